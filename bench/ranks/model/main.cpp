/// @file
/// Foretells what a world over ranks costs, from runs on few, and holds the forecast against them.
#include <cstdio>
#include <string>

#include "ranks/model/runs.h"
#include "report/gnuplot.h"
#include "report/text_file.h"

namespace {

using namespace cellsweep;
using namespace cellsweep::ranks_bench;

constexpr const char* kUsage =
    "usage: cellsweep_ranks_model RUNS.json [CHART.png]\n"
    "RUNS.json is a list of what ./run bench ranks prints. Prints tables for docs/ranks.md; fails where a\n"
    "forecast of ghosts or bytes is off by more than 5 %.\n";

Status run(int argc, char** argv) {
  const auto json = report::read_text_file(argv[1]);
  if (!json) return json.status();
  const auto runs = read_runs(*json);
  if (!runs) return runs.status();
  const Costs costs = fit(*runs);
  std::printf("%.1f ns a body, %.0f ns a ghost, %.4f enter a frame for each ghost\n\n%s\n%s", costs.ns_a_body,
              costs.ns_a_ghost, costs.enters_a_ghost, measured_markdown(*runs, costs).c_str(),
              forecast_markdown(costs).c_str());
  if (argc > 2) {
    const auto chart = report::run_gnuplot("the chart", chart_script(*runs, costs), "IEND\xae\x42\x60\x82");
    if (!chart) return chart.status();
    if (Status status = report::write_text_file(argv[2], *chart); !status.ok()) return status;
  }
  if (largest_error(*runs, costs) <= 0.05) return {};
  return Status::bad_input("A forecast of ghosts or bytes is off by more than 5 %.");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  const Status status = run(argc, argv);
  if (status.ok()) return 0;
  std::fprintf(stderr, "%s\n", status.message.c_str());
  return 1;
}
