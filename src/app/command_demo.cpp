#include "app/checks.h"
#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/output.h"
#include "app/run_and_print.h"
#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/scene.h"
#include "report/interrupt.h"
#include "report/quantile.h"
#include "report/run_engine.h"
#include "report/table.h"
#include "report/units.h"
#include "report/verify.h"

namespace cellsweep::app {
namespace {

// Runs every engine over a recording and over scene `paper`, compares each with the oracle, one row for each.
class Demo {
 public:
  std::string file;
  std::size_t updates = 300;

  ExitCode run() {
    const report::InterruptScope interrupts;
    if (const Status status = run_recording(); !status.ok()) return complain(status);
    const SceneSettings paper;
    const Status status = run_source(paper.bodies, [&] { return make_scene_frames(paper); });
    if (!status.ok()) return complain(status);
    print_text(table_.text());
    print_text(
        "\nset-up: what an engine does once per body ever inserted (control fills its map of all pairs).\n"
        "oracle: every frame compared with all-against-all.\n");
    return end_with(all_exact_ ? kGood : kResultsDiffer, "The last row is of the frames until then.");
  }

 private:
  Status run_recording() {
    if (file.empty()) return {};
    const auto recording = read_frame_file(file);
    if (!recording) return recording.status();
    return run_source(recording->ids(),
                      [&]() -> Result<std::unique_ptr<FrameSource>> { return recording->make_source(); });
  }

  Status run_source(std::size_t bodies, const SourceMaker& make_source) {
    auto engines = EngineFlags().make(bodies);
    if (!engines) return engines.status();
    for (const report::FedEngine& fed : *engines) {
      if (report::is_interrupted()) return {};
      if (Status status = run_engine_on(fed.engine.name(), make_source); !status.ok()) return status;
    }
    return {};
  }

  // Timed, and then, by another engine of that name, judged.
  Status run_engine_on(std::string_view name, const SourceMaker& make_source) {
    auto engine = make_broadphase(name);
    if (!engine) return engine.status();
    auto source = make_source();
    if (!source) return source.status();
    const auto run = report::run_engine(*engine, **source, {updates, {}});
    if (!run) return run.status();
    const auto verdict = verdict_on(name, make_source);
    if (!verdict) return verdict.status();
    add_row((*source)->name(), *run, *verdict);
    return {};
  }

  Result<report::VerifyReport> verdict_on(std::string_view name, const SourceMaker& make_source) const {
    auto engine = make_broadphase(name);
    if (!engine) return engine.status();
    auto source = make_source();
    if (!source) return source.status();
    std::vector<report::FedEngine> engines;
    engines.push_back({std::move(*engine), report::Shape::boxes});
    const auto verdicts = report::verify_engines(engines, **source, updates);
    if (!verdicts) return verdicts.status();
    return verdicts->front();
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
      program.add_subcommand("demo", "Run every engine on a recording and on scene paper, verified");
  auto demo = std::make_shared<Demo>();
  command->add_option("FILE", demo->file, "A recording; without one, only the scene is run");
  command->add_option("--frames", demo->updates, "Updates after frame 0; of a recording as many as it has")
      ->check(count())
      ->type_name("N")
      ->capture_default_str();
  command->footer(
      "Engines that do not hold all bodies are left out.\n"
      "Example:\n"
      "  cellsweep demo bench/scenes/bullet-pile-1024.aabbs");
  command->callback([demo, &exit_code] { exit_code = demo->run(); });
}

}  // namespace cellsweep::app
