#include "app/run_and_print.h"

#include "report/run_json.h"
#include "report/run_table.h"

namespace cellsweep::app {

ExitCode run_and_print(const EngineFlags& engine_flags, const FrameFlags& frame_flags,
                       const SourceMaker& make_source) {
  auto engines = engine_flags.make();
  if (!engines) return complain(engines.status());
  report::RunSettings settings = frame_flags.settings;
  settings.shape = engine_flags.shape();
  std::vector<report::RunReport> runs;
  std::string source_name;
  for (const auto& engine : *engines) {
    auto source = make_source();
    if (!source) return complain(source.status());
    source_name = (*source)->name();
    auto run = report::run_engine(*engine, **source, settings);
    if (!run) return complain(run.status());
    runs.push_back(std::move(*run));
  }
  if (frame_flags.json) {
    print_json(report::to_json(runs));
  } else {
    print_text(report::run_table(source_name, runs) + "\n" + report::frame_table(runs));
  }
  return kGood;
}

}  // namespace cellsweep::app
