#include "bench/peers/chart/pages.h"

#include <string>

#include "bench/measured/page_marks.h"
#include "bench/peers/chart/tables.h"
#include "report/text_file.h"

namespace cellsweep::bench {
namespace {

Result<std::string> page_with(const std::filesystem::path& page, const std::string& content) {
  const Result<std::string> text = report::read_text_file(page);
  return text ? replace_between_marks(*text, "peers", content) : text;
}

}  // namespace

Status update_pages(const std::filesystem::path& project, const PeerResults& results,
                    const std::filesystem::path& chart) {
  const std::filesystem::path first_page = project / "README.md";
  const std::filesystem::path page = project / "docs/peers.md";
  const Result<std::string> first_text = page_with(first_page, headline_markdown(results));
  const Result<std::string> text = page_with(page, summary_markdown(results));
  const Result<std::string> picture = report::read_text_file(chart);
  if (!first_text) return first_text.status();
  if (!text) return text.status();
  if (!picture) return picture.status();
  if (Status status = report::write_text_file(project / "bench/figures/peers.png", *picture); !status.ok()) {
    return status;
  }
  if (Status status = report::write_text_file(page, *text); !status.ok()) return status;
  return report::write_text_file(first_page, *first_text);
}

}  // namespace cellsweep::bench
