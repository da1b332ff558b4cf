#include "app/checks.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/scene_flags.h"
#include "app/watched_frames.h"
#include "base/text.h"
#include "cellsweep/world/recording.h"

namespace cellsweep::app {
namespace {

struct Record {
  SceneFlags scene;
  std::size_t updates = 100;
  std::string from;
  std::string out;

  Result<Recording> make() const {
    if (!from.empty()) return read_recording(from);
    const auto bounds = scene_bounds(scene.settings);
    if (!bounds) return bounds.status();
    auto source = make_scene_frames(scene.settings);
    if (!source) return source.status();
    WatchedFrames watched(**source, "record, frame", updates);
    return record(watched, updates, *bounds);
  }

  ExitCode run() const {
    if (const Status status = check_ending(out, {".aabbs", ".npy"}); !status.ok()) return complain(status);
    const report::InterruptScope interrupts;
    const auto recording = make();
    if (!recording) return complain(recording.status());
    if (const Status status = write_recording(*recording, out); !status.ok()) return complain(status);
    print_text(text(out, ": ", recording->bodies, " bodies, ", recording->frames(), " frames\n"));
    return end_with(kGood, "The file holds the frames until then.");
  }
};

}  // namespace

void add_record(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand("record", "Write a scene, or another recording, to a file");
  auto record = std::make_shared<Record>();
  command->add_option("--out", record->out, "File to write: .aabbs or .npy")->required()->type_name("FILE");
  auto* from = command->add_option("--from", record->from, "Recording to convert, instead of a scene")
                   ->type_name("FILE");
  record->scene.add_to(*command);
  command->add_option("--frames", record->updates, "Updates after frame 0")
      ->check(count())
      ->type_name("N")
      ->capture_default_str()
      ->excludes(from);
  command->footer(
      "Examples:\n"
      "  cellsweep record --scene clustered --frames 60 --out clustered.aabbs\n"
      "  cellsweep record --from bench/scenes/bullet-pile-1024.aabbs --out pile.npy");
  command->callback([record, &exit_code] { exit_code = record->run(); });
}

}  // namespace cellsweep::app
