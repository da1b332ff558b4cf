/// @file
/// Makes tables and charts of what the suite of peers measured.
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "bench/measured/table_program.h"
#include "bench/peers/chart/chart_script.h"
#include "bench/peers/chart/pages.h"
#include "bench/peers/chart/tables.h"
#include "bench/peers/peer_mode.h"
#include "report/gnuplot.h"
#include "report/text_file.h"

namespace {

using namespace cellsweep;
using namespace cellsweep::bench;

constexpr std::string_view kUsage =
    "usage: peers-chart [--docs] [FILE.json...]\n"
    "Reads what ./run bench peers measured (out/peers/peers.json, unless files are named) and writes into\n"
    "out/peers a chart for each scene (SCENE.png), tables (tables.md) and all times (times.csv).\n"
    "  --docs   also puts the summary into docs/peers.md, its sentence into README.md, and the chart of "
    "scene\n"
    "           uniform into bench/figures\n";

const std::filesystem::path kOut = "out/peers";

constexpr std::string_view kEndOfPng = "IEND\xae\x42\x60\x82";

Status read_all(const std::vector<std::string>& files, PeerResults& results) {
  for (const std::string& file : files) {
    const Result<std::string> json = report::read_text_file(file);
    if (!json) return json.status();
    if (Status status = add_results(*json, results); !status.ok()) return status;
  }
  return {};
}

Status draw_all(const PeerResults& results) {
  for (std::size_t scene = 0; scene < kPeerScenes.size(); ++scene) {
    const std::string name(kPeerScenes[scene]);
    const std::string script = chart_script(results, scene);
    const auto chart = report::run_gnuplot(name + ".gnuplot", script, kEndOfPng);
    if (!chart) return chart.status();
    const std::string alone = text("# gnuplot ", name, ".gnuplot >", name, ".png\n", script);
    if (Status status = report::write_text_file(kOut / (name + ".gnuplot"), alone); !status.ok())
      return status;
    if (Status status = report::write_text_file(kOut / (name + ".png"), *chart); !status.ok()) return status;
  }
  return {};
}

Status write_tables(const PeerResults& results) {
  const std::string tables = results.machine + "\n\n" + summary_markdown(results) + "\n" +
                             cells_markdown(results) + "\n" + tails_markdown(results);
  std::fputs(tables.c_str(), stdout);
  if (Status status = report::write_text_file(kOut / "tables.md", tables); !status.ok()) return status;
  return report::write_text_file(kOut / "times.csv", times_csv(results));
}

Status run(const std::vector<std::string>& files, bool docs) {
  PeerResults results;
  if (Status status = report::find_gnuplot(); !status.ok()) return status;
  if (Status status = read_all(files, results); !status.ok()) return status;
  if (Status status = report::make_folder(kOut); !status.ok()) return status;
  if (Status status = write_tables(results); !status.ok()) return status;
  if (Status status = draw_all(results); !status.ok()) return status;
  return docs ? update_pages(".", results, kOut / "uniform.png") : Status{};
}

}  // namespace

int main(int argc, char** argv) {
  return run_table_program({"peers-chart", kUsage, "out/peers/peers.json", run}, argc, argv);
}
