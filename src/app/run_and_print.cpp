#include "app/run_and_print.h"

#include "report/cell_time.h"
#include "report/run_json.h"
#include "report/run_table.h"

namespace cellsweep::app {
namespace {

nlohmann::ordered_json as_json(const std::vector<report::RunReport>& runs, const EngineFlags& engine_flags) {
  nlohmann::ordered_json json = report::to_json(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].cell.empty())
      json["engines"][i]["cell"] = report::cell_json(runs[i], engine_flags.ppu_costs());
  }
  return json;
}

}  // namespace

ExitCode run_and_print(const EngineFlags& engine_flags, const FrameFlags& frame_flags,
                       const SourceMaker& make_source) {
  if (engine_flags.options().cycles && engine_flags.options().spe_engine != SpeEngine::isa) {
    return complain({StatusCode::bad_option,
                     "--cycles counts what real SPU code does; it needs --spe-engine isa, too.", std::nullopt,
                     0, 0, "cycles"});
  }
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
    print_json(as_json(runs, engine_flags));
  } else {
    print_text(report::run_table(source_name, runs) + "\n" + report::frame_table(runs));
    if (engine_flags.options().cycles) {
      print_text("\n" + report::cell_tables(runs, engine_flags.ppu_costs()));
    }
  }
  return kGood;
}

}  // namespace cellsweep::app
