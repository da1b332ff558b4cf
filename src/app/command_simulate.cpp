#include "app/commands.h"
#include "app/run_and_print.h"
#include "app/scene_flags.h"

namespace cellsweep::app {
namespace {

struct Simulate {
  SceneFlags scene;
  FrameFlags frames;
  EngineFlags engines;

  ExitCode run() const {
    return run_and_print(engines, frames, scene.settings.bodies,
                         [this] { return make_scene_frames(scene.settings); });
  }
};

}  // namespace

void add_simulate(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand("simulate", "Run a scene made from a seed");
  auto simulate = std::make_shared<Simulate>();
  simulate->scene.add_to(*command);
  simulate->scene.add_filters_to(*command);
  simulate->frames.add_to(*command, 100, "100");
  simulate->engines.add_to(*command, EngineFlags::Purpose::times);
  command->footer(
      "Example:\n"
      "  cellsweep simulate --scene varied --bodies 2000 --moving 0.1 --frames 1000 \\\n"
      "    --engine control");
  command->callback([simulate, &exit_code] { exit_code = simulate->run(); });
}

}  // namespace cellsweep::app
