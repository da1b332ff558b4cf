#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/checks.h"
#include "app/commands.h"
#include "app/frame_range.h"
#include "app/output.h"
#include "app/scene_flags.h"
#include "base/text.h"
#include "cellsweep/world/frame_file.h"
#include "report/folder_lock.h"
#include "report/interrupt.h"
#include "report/picture/cuts.h"
#include "report/picture/picture.h"
#include "report/progress.h"
#include "report/text_file.h"

namespace cellsweep::app {
namespace {

struct Render {
  std::string file;
  SceneFlags scene;
  std::size_t frame = 0;
  FrameRange range;
  std::string cuts;
  std::filesystem::path out;
  report::PictureSettings picture;

  ExitCode run() {
    if (!range.given()) {
      if (const Status status = check_ending(out, {".png"}); !status.ok()) return complain(status);
    }
    Aabb world;
    if (const Status status = read_regions(); !status.ok()) return complain(status);
    auto source = make_source(world);
    if (!source) return complain(source.status());
    if (range.given()) return draw_sequence(**source, world);
    const Status status = draw_one(**source, world);
    return status.ok() ? kGood : complain(status);
  }

 private:
  Result<std::unique_ptr<FrameSource>> make_source(Aabb& world_bounds) const {
    if (file.empty()) {
      const auto bounds = scene_bounds(scene.settings);
      if (!bounds) return bounds.status();
      world_bounds = *bounds;
      return make_scene_frames(scene.settings);
    }
    const auto recording = read_frame_file(file);
    if (!recording) return recording.status();
    world_bounds = report::stage_of(*recording);
    return recording->make_source();
  }

  Status read_regions() {
    if (cuts.empty()) return {};
    const auto words = report::read_text_file(cuts);
    if (!words) return words.status();
    auto read = report::read_cuts(*words);
    if (!read) return Status::bad_input(text("--cuts ", cuts, ": ", read.status().message));
    regions_ = std::move(*read);
    return {};
  }

  Status draw(const FrameSource& source, const Aabb& world, const std::filesystem::path& path) const {
    report::Tableau tableau = report::tableau_of(source, world);
    if (!regions_.empty()) {
      std::vector<Aabb> boxes;
      for (const BodyId body : report::shown_bodies(source, world)) boxes.push_back(source.boxes()[body]);
      report::show_cuts(regions_, boxes, tableau);
    }
    const auto image = report::trace_picture(tableau, picture);
    if (!image) return image.status();
    return report::write_png(*image, path);
  }

  Status draw_one(FrameSource& source, const Aabb& world) {
    std::size_t at = 0;
    if (Status status = go_to_frame(source, at, frame, "render"); !status.ok()) return status;
    report::Progress progress("render, row", picture.height);
    picture.row_done = [&](unsigned row) { progress.show(row); };
    return draw(source, world, out);
  }

  ExitCode draw_sequence(FrameSource& source, const Aabb& world) const {
    const report::InterruptScope interrupts;
    std::size_t drawn = 0;
    if (const Status status = draw_all(source, world, drawn); !status.ok()) return complain(status);
    return end_with(kGood, text(drawn, " of ", range.count(), " pictures were drawn."));
  }

  // OUT/00012.png and so on, as tools that make films of pictures want them.
  Status draw_all(FrameSource& source, const Aabb& world, std::size_t& drawn) const {
    report::FolderLock folder;
    if (Status status = folder.take(out); !status.ok()) return status;
    report::Progress progress("pictures", range.count());
    std::size_t at = 0;
    for (std::size_t wanted = range.first; wanted <= range.last && !report::is_interrupted(); ++wanted) {
      if (Status status = go_to_frame(source, at, wanted, "render"); !status.ok()) return status;
      if (Status status = draw(source, world, out / numbered_png(wanted)); !status.ok()) return status;
      progress.show(++drawn);
    }
    return {};
  }

  std::vector<Aabb> regions_;
};

void add_number(CLI::App& command, const std::string& flag, unsigned& number, const std::string& help,
                std::uint64_t least, std::uint64_t most) {
  command.add_option(flag, number, help)->check(count(least, most))->type_name("N")->capture_default_str();
}

void add_picture_flags(CLI::App& command, report::PictureSettings& picture) {
  constexpr std::uint64_t kMostPixels = 16384;
  constexpr std::uint64_t kMostSamples = 4096;
  add_number(command, "--width", picture.width, "Pixels across", 1, kMostPixels);
  add_number(command, "--height", picture.height, "Pixels down", 1, kMostPixels);
  add_number(command, "--samples", picture.samples, "Rays a pixel: more is smoother and takes longer", 1,
             kMostSamples);
  add_number(command, "--threads", picture.threads, "Threads; 0: one for each core", 0, kMostThreads);
}

}  // namespace

void add_render(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand(
      "render", "Draw a frame of a scene or recording as a ray-traced picture; colliding boxes are green");
  auto render = std::make_shared<Render>();
  auto* file = command->add_option("FILE", render->file, "A recording; without one, a scene is drawn");
  render->scene.add_to(*command);
  render->scene.add_filters_to(*command);
  SceneFlags::exclude_beside(*command, *file);
  auto* frame = command->add_option("--frame", render->frame, "Frame to draw")
                    ->check(count())
                    ->type_name("N")
                    ->capture_default_str();
  command
      ->add_option("--frames", render->range, "Frames A to B, each a picture of its own in the folder --out")
      ->type_name("A:B")
      ->excludes(frame);
  command
      ->add_option("--cuts", render->cuts,
                   "What cellsweep-ranks --json printed: bodies in the colours of its ranks' regions")
      ->type_name("FILE");
  command->add_option("--out", render->out, "PNG file; with --frames, a folder")
      ->type_name("FILE")
      ->required();
  add_picture_flags(*command, render->picture);
  command->footer(
      "Examples:\n"
      "  cellsweep render --scene paper --bodies 1024 --frame 100 --out scene.png\n"
      "  cellsweep render bench/scenes/bullet-pile-1024.aabbs --frames 0:30 --out pile\n"
      "  cellsweep render --bodies 1000 --cuts ranks.json --out cuts.png\n"
      "Ctrl-C ends a sequence after the picture that is being drawn.");
  command->callback([render, &exit_code] { exit_code = render->run(); });
}

}  // namespace cellsweep::app
