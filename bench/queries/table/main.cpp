/// @file
/// Makes tables of what the suite of queries measured.
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measured/page_marks.h"
#include "bench/measured/table_program.h"
#include "bench/queries/table/query_tables.h"
#include "report/text_file.h"

namespace {

using namespace cellsweep;
using namespace cellsweep::bench;

constexpr std::string_view kUsage =
    "usage: queries-table [--docs] [FILE.json...]\n"
    "Reads what ./run bench queries measured (out/queries/queries.json, unless files are named), prints how "
    "many\n"
    "times as long as stream the best of the others took, and writes out/queries/tables.md.\n"
    "  --docs   also puts the summary, and frames, into docs/query-speed.md\n";

Status put_into_page(const QueryResults& results) {
  const std::filesystem::path page = "docs/query-speed.md";
  Result<std::string> text = report::read_text_file(page);
  if (text && !results.cells.empty()) text = replace_between_marks(*text, "queries", query_summary(results));
  if (text && !results.frames.empty()) text = replace_between_marks(*text, "frames", frame_cells(results));
  if (!text) return text.status();
  return report::write_text_file(page, *text);
}

Status run(const std::vector<std::string>& files, bool docs) {
  QueryResults results;
  for (const std::string& file : files) {
    const Result<std::string> json = report::read_text_file(file);
    if (!json) return json.status();
    if (Status status = add_query_results(*json, results); !status.ok()) return status;
  }
  const std::string tables = results.machine + "\n\n" + query_summary(results) + "\n" + query_cells(results) +
                             "\n" + moved_cells(results) + "\n" + frame_cells(results);
  std::fputs(tables.c_str(), stdout);
  if (Status status = report::make_folder("out/queries"); !status.ok()) return status;
  if (Status status = report::write_text_file("out/queries/tables.md", tables); !status.ok()) return status;
  return docs ? put_into_page(results) : Status{};
}

}  // namespace

int main(int argc, char** argv) {
  return run_table_program({"queries-table", kUsage, "out/queries/queries.json", run}, argc, argv);
}
