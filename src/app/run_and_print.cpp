#include "app/run_and_print.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "report/cell_time.h"
#include "report/interrupt.h"
#include "report/run_json.h"
#include "report/run_table.h"

namespace cellsweep::app {
namespace {

/// What came of all engines.
struct Runs {
  std::string source;
  std::vector<report::RunReport> reports;
};

nlohmann::ordered_json as_json(const Runs& runs, const report::PpuCosts& ppu_costs) {
  nlohmann::ordered_json json = report::to_json(runs.reports);
  for (std::size_t i = 0; i < runs.reports.size(); ++i) {
    if (!runs.reports[i].cell.empty())
      json["engines"][i]["cell"] = report::cell_json(runs.reports[i], ppu_costs);
  }
  return json;
}

void print(const Runs& runs, const report::PpuCosts& ppu_costs, bool json) {
  if (json) return print_json(as_json(runs, ppu_costs));
  print_text(report::run_table(runs.source, runs.reports) + "\n" + report::frame_table(runs.reports));
  const bool any_on_a_cell = std::any_of(runs.reports.begin(), runs.reports.end(),
                                         [](const report::RunReport& run) { return !run.cell.empty(); });
  if (any_on_a_cell) print_text("\n" + report::cell_tables(runs.reports, ppu_costs));
}

// Each engine goes when it is done, with all that it holds.
Status run_all(std::vector<report::FedEngine> engines, const SourceMaker& make_source,
               report::RunSettings settings, Runs& runs) {
  for (report::FedEngine& fed : engines) {
    if (report::is_interrupted()) break;
    report::FedEngine mine = std::move(fed);
    auto source = make_source();
    if (!source) return source.status();
    runs.source = (*source)->name();
    settings.shape = mine.shape;
    auto run = report::run_engine(mine.engine, **source, settings);
    if (!run) return run.status();
    runs.reports.push_back(std::move(*run));
  }
  return {};
}

// "The last engine was at frame 12; 2 engines were not run."
std::string interruption_text(const Runs& runs, std::size_t engines) {
  if (runs.reports.empty()) return "Nothing was run.";
  const report::RunReport& last = runs.reports.back();
  const std::size_t left = engines - runs.reports.size();
  return text("Of ", last.engine, " there are ", last.update_ms.size(), " updates after frame 0",
              left > 0 ? text("; ", left, left == 1 ? " more engine was" : " more engines were", " not run.")
                       : std::string("."));
}

}  // namespace

ExitCode run_and_print(const EngineFlags& engine_flags, const FrameFlags& frame_flags, std::size_t bodies,
                       const SourceMaker& make_source) {
  auto engines = engine_flags.make(bodies);
  if (!engines) return complain(engines.status());
  const report::InterruptScope interrupts;
  const std::size_t count = engines->size();
  Runs runs;
  if (const Status status = run_all(std::move(*engines), make_source, frame_flags.settings, runs);
      !status.ok())
    return complain(status);
  print(runs, engine_flags.ppu_costs(), frame_flags.json);
  return end_with(kGood, interruption_text(runs, count));
}

}  // namespace cellsweep::app
