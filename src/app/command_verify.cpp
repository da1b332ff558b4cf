#include <algorithm>
#include <optional>

#include "app/checks.h"
#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/output.h"
#include "app/scene_flags.h"
#include "cellsweep/world/frame_file.h"
#include "report/interrupt.h"
#include "report/progress.h"
#include "report/run_json.h"
#include "report/run_table.h"

namespace cellsweep::app {
namespace {

constexpr std::size_t kSceneUpdates = 100;

struct Verify {
  std::string file;
  SceneFlags scene;
  EngineFlags engines;
  std::optional<std::size_t> updates;
  bool json = false;

  Result<std::unique_ptr<FrameSource>> make_source() const {
    if (file.empty()) return make_scene_frames(scene.settings);
    const auto recording = read_frame_file(file);
    if (!recording) return recording.status();
    return recording->make_source();
  }

  // A recording ends by itself, a scene never does.
  std::size_t last_update() const {
    return updates.value_or(file.empty() ? kSceneUpdates : report::Progress::kOpenEnd);
  }

  ExitCode run() const {
    if (const Status status = engines.check(); !status.ok()) return complain(status);
    auto source = make_source();
    if (!source) return complain(source.status());
    auto made = engines.make((*source)->boxes().size());
    if (!made) return complain(made.status());
    const std::string name = (*source)->name();
    const report::InterruptScope interrupts;
    const auto verdicts = report::verify_engines(*made, **source, last_update());
    if (!verdicts) return complain(verdicts.status());
    print_verdicts(name, *verdicts);
    const bool exact =
        std::all_of(verdicts->begin(), verdicts->end(), [](const auto& v) { return v.exact(); });
    return end_with(exact ? kGood : kResultsDiffer, "The verdicts are of the frames until then.");
  }

  void print_verdicts(const std::string& name, const std::vector<report::VerifyReport>& verdicts) const {
    if (json) return print_json(report::to_json(verdicts));
    print_text(report::verify_table(name, verdicts));
    for (const auto& verdict : verdicts) {
      if (verdict.first) print_text("\n" + verdict.engine + ", " + report::describe(*verdict.first) + "\n");
    }
  }
};

}  // namespace

void add_verify(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command =
      program.add_subcommand("verify", "Compare engines with all-against-all, frame by frame");
  auto verify = std::make_shared<Verify>();
  auto* file = command->add_option("FILE", verify->file, "A recording; without one, a scene is run");
  verify->scene.add_to(*command);
  verify->scene.add_filters_to(*command);
  SceneFlags::exclude_beside(*command, *file);
  command->add_option("--frames", verify->updates, "Updates after frame 0")
      ->check(count())
      ->type_name("N")
      ->default_str("all of a recording, 100 of a scene");
  verify->engines.add_to(*command, EngineFlags::Purpose::verdicts);
  command->add_flag("--json", verify->json, "One JSON object on standard output");
  command->footer(
      "Exit code 1 and the first differing pair when an engine is not exact.\n"
      "Examples:\n"
      "  cellsweep verify bench/scenes/bullet-pile-1024.aabbs\n"
      "  cellsweep verify --scene wall --bodies 500 --moving 1 --spinning --frames 300\n"
      "A frame is compared with all boxes against all boxes, which takes time with the\n"
      "square of the bodies: with 100,000 of them minutes.");
  command->callback([verify, &exit_code] { exit_code = verify->run(); });
}

}  // namespace cellsweep::app
