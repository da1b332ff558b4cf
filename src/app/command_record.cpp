#include <utility>

#include "app/checks.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/scene_flags.h"
#include "app/watched_frames.h"
#include "base/text.h"
#include "cellsweep/world/frame_file.h"
#include "report/picture/picture.h"

namespace cellsweep::app {
namespace {

struct Record {
  SceneFlags scene;
  std::size_t updates = 100;
  std::string from;
  std::string out;

  ExitCode run() const {
    if (const Status status = check_ending(out, {".aabbs", ".npy", ".npz"}); !status.ok())
      return complain(status);
    const report::InterruptScope interrupts;
    const auto written = from.empty() ? write_scene() : write_file();
    if (!written) return complain(written.status());
    print_text(text(out, ": ", written->ids, " bodies, ", written->frames, " frames\n"));
    return end_with(kGood, "The file holds the frames until then.");
  }

 private:
  Result<FramesWritten> write_scene() const {
    const auto bounds = scene_bounds(scene.settings);
    if (!bounds) return bounds.status();
    auto source = make_scene_frames(scene.settings);
    if (!source) return source.status();
    WatchedFrames watched(**source, "record, frame", updates);
    return write_frame_file(watched, updates, *bounds, out);
  }

  Result<FramesWritten> write_file() const {
    const auto file = read_frame_file(from);
    if (!file) return file.status();
    return write_frame_file(*file->make_source(), file->frames(), file->world(), out);
  }
};

}  // namespace

void add_record(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand("record", "Write a scene, or another recording, to a file");
  auto record = std::make_shared<Record>();
  command->add_option("--out", record->out, "File to write: .aabbs, .npy or .npz")
      ->required()
      ->type_name("FILE");
  auto* from = command->add_option("--from", record->from, "Recording to convert, instead of a scene")
                   ->type_name("FILE");
  record->scene.add_to(*command);
  record->scene.add_filters_to(*command);
  SceneFlags::exclude_beside(*command, *from);
  command->add_option("--frames", record->updates, "Updates after frame 0")
      ->check(count())
      ->type_name("N")
      ->capture_default_str()
      ->excludes(from);
  command->footer(
      "Examples:\n"
      "  cellsweep record --scene clustered --frames 60 --out clustered.aabbs\n"
      "  cellsweep record --scene open-world --static --out open-world.npz\n"
      "  cellsweep record --from bench/scenes/bullet-pile-1024.aabbs --out pile.npy");
  command->callback([record, &exit_code] { exit_code = record->run(); });
}

}  // namespace cellsweep::app
