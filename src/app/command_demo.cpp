#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/output.h"
#include "app/run_and_print.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/scene.h"
#include "report/quantile.h"
#include "report/run_engine.h"
#include "report/table.h"
#include "report/verify.h"

namespace cellsweep::app {
namespace {

// Runs every engine over a recording and over scene `paper`, compares each with the oracle, one row for each.
class Demo {
 public:
  std::string file;
  std::size_t updates = 300;

  ExitCode run() {
    if (const Status status = run_recording(); !status.ok()) return complain(status);
    const auto make_paper = [] { return make_scene_frames(SceneSettings{}); };
    if (const Status status = run_source(make_paper); !status.ok()) return complain(status);
    print_text(table_.text());
    print_text(
        "\nset-up: what an engine does once per body ever inserted (control fills its map of all pairs).\n"
        "oracle: every frame compared with all-against-all.\n");
    return all_exact_ ? kGood : kResultsDiffer;
  }

 private:
  Status run_recording() {
    if (file.empty()) return {};
    const auto recording = read_recording(file);
    if (!recording) return recording.status();
    return run_source(
        [&]() -> Result<std::unique_ptr<FrameSource>> { return make_recording_frames(*recording); });
  }

  Status run_source(const SourceMaker& make_source) {
    for (const EngineInfo& info : engine_table()) {
      if (Status status = run_engine_on(info.name, make_source); !status.ok()) return status;
    }
    return {};
  }

  Status run_engine_on(std::string_view name, const SourceMaker& make_source) {
    auto engine = make_engine(name);
    if (!engine) return engine.status();
    auto source = make_source();
    if (!source) return source.status();
    const auto run = report::run_engine(**engine, **source, {updates, {}});
    if (!run) return run.status();

    Engines fresh;
    if (auto again = make_engine(name)) fresh.push_back(std::move(*again));
    auto second_source = make_source();
    if (!second_source) return second_source.status();
    const auto verdicts = report::verify_engines(fresh, **second_source, updates);
    if (!verdicts) return verdicts.status();
    add_row((*source)->name(), *run, verdicts->front());
    return {};
  }

  void add_row(const std::string& source, const report::RunReport& run, const report::VerifyReport& verdict) {
    all_exact_ = all_exact_ && verdict.exact();
    const report::FrameReport& last = run.frames.back();
    table_.add({source, run.engine, std::to_string(run.bodies), std::to_string(run.update_ms.size()),
                report::duration_text(run.setup_ms), report::duration_text(run.initial_ms),
                report::duration_text(report::quantile(run.update_ms, 0.5)),
                report::duration_text(report::quantile(run.update_ms, 1.0)), std::to_string(last.pairs),
                hash_text(last.hash), verdict.exact() ? "exact" : "differs"});
  }

  report::Table table_{{"source", "engine", "bodies", "updates", "set-up", "initial", "median", "longest",
                        "pairs at end", "hash at end", "oracle"},
                       2};
  bool all_exact_ = true;
};

}  // namespace

void add_demo(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command =
      program.add_subcommand("demo", "Run every engine on a recording and on scene `paper`, verified");
  auto demo = std::make_shared<Demo>();
  command->add_option("FILE", demo->file, "A recording; without one, only the scene is run");
  command->add_option("--frames", demo->updates, "Updates after frame 0; of a recording as many as it has")
      ->capture_default_str();
  command->footer("Example:\n  cellsweep demo bench/scenes/bullet-pile-1024.aabbs");
  command->callback([demo, &exit_code] { exit_code = demo->run(); });
}

}  // namespace cellsweep::app
