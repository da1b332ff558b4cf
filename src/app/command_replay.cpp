#include "app/commands.h"
#include "app/run_and_print.h"
#include "cellsweep/world/frame_file.h"
#include "report/progress.h"

namespace cellsweep::app {
namespace {

struct Replay {
  std::string file;
  FrameFlags frames;
  EngineFlags engines;

  ExitCode run() const {
    const auto recording = read_frame_file(file);
    if (!recording) return complain(recording.status());
    return run_and_print(engines, frames, recording->ids(),
                         [&]() -> Result<std::unique_ptr<FrameSource>> { return recording->make_source(); });
  }
};

}  // namespace

void add_replay(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand("replay", "Run a recorded scene");
  auto replay = std::make_shared<Replay>();
  command
      ->add_option("FILE", replay->file,
                   "A recording: .aabbs, .npy of shape (frames, bodies, 6), or a .npz trace")
      ->required();
  replay->frames.add_to(*command, report::Progress::kOpenEnd, "all there are");
  replay->engines.add_to(*command, EngineFlags::Purpose::times);
  command->footer(
      "Example:\n"
      "  cellsweep replay bench/scenes/bullet-pile-1024.aabbs --json \\\n"
      "    --report-frames 0,15,30");
  command->callback([replay, &exit_code] { exit_code = replay->run(); });
}

}  // namespace cellsweep::app
