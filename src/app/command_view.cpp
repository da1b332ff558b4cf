#include <algorithm>

#include "app/answer.h"
#include "app/checks.h"
#include "app/commands.h"
#include "app/engine_flags.h"
#include "app/output.h"
#include "app/scene_flags.h"
#include "base/text.h"
#include "view/view.h"

namespace cellsweep::app {
namespace {

struct View {
  std::string file;
  SceneFlags scene;
  EngineFlags engines;
  view::ViewSettings window;
  bool no_panel = false;
  std::string box;
  std::string ray;
  std::size_t recorded_frames = 0;  // 0: a scene

  ExitCode run() {
    if (const Status status = check(); !status.ok()) return complain(status);
    if (const Status status = take_tool(); !status.ok()) return complain(status);
    view::SimulationSettings settings{std::nullopt, scene.settings, engines.names().front(),
                                      engines.values()};
    if (!file.empty()) {
      auto recording = read_frame_file(file);
      if (!recording) return complain(recording.status());
      recorded_frames = std::max<std::size_t>(1, recording->frames());
      settings.recording = std::move(*recording);
    }
    auto simulation = view::Simulation::make(std::move(settings));
    if (!simulation) return complain(simulation.status());
    window.panel = !no_panel;
    const view::ViewEnd end = view::show(**simulation, window);
    if (!end.no_display.empty()) return complain_of_display(end.no_display);
    return end.status.ok() ? kGood : complain(end.status);
  }

 private:
  Status check() const {
    if (engines.names().size() != 1) {
      return Status::bad_option("engine",
                                "The window shows one engine at a time; its panel and keys change it.",
                                engines.names().size(), 1);
    }
    if (!window.screenshot.empty()) {
      if (Status status = check_ending(window.screenshot, {".png"}); !status.ok()) return status;
    }
    return engines.check();
  }

  // What --box and --ray hold into the world is what `query` takes.
  Status take_tool() {
    for (const QuestionKind& kind : question_kinds()) {
      const std::string& typed = kind.form == QuestionForm::box ? box : ray;
      const bool is_mine = kind.form == QuestionForm::box || kind.form == QuestionForm::ray;
      if (!is_mine || typed.empty()) continue;
      const auto question = question_of_flag(kind, typed, {});
      if (!question) return question.status();
      if (const auto answer = ask(Broadphase(), *question); !answer) return answer.status();
      if (kind.form == QuestionForm::box) window.box = region_of(*question).box;
      if (kind.form == QuestionForm::ray)
        window.ray = {path_of(*question).box.min, path_of(*question).direction};
    }
    return {};
  }

  ExitCode complain_of_display(const std::string& why) const {
    say(text("There is no display with OpenGL 3.3 to open a window on (", why, "). A picture needs none:\n  ",
             render_command()));
    return kNoDisplay;
  }

  // What draws the picture that the window would have shown last; it plays recordings again and again.
  std::string render_command() const {
    const std::size_t steps = window.frames.value_or(0);
    const std::string what = file.empty() ? scene.text() : "'" + file + "'";
    const std::string out = window.screenshot.empty() ? "scene.png" : window.screenshot.string();
    return text("cellsweep render ", what, " --frame ",
                recorded_frames == 0 ? steps : steps % recorded_frames, " --width ", window.width,
                " --height ", window.height, " --out '", out, "'");
  }
};

}  // namespace

void add_view(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand(
      "view", "Show a scene or recording in a window while an engine works on it; colliding boxes are green");
  auto view = std::make_shared<View>();
  auto* file = command->add_option("FILE", view->file, "A recording; without one, a scene is run");
  view->scene.add_to(*command);
  view->scene.add_filters_to(*command);
  SceneFlags::exclude_beside(*command, *file);
  view->engines.add_to(*command, EngineFlags::Purpose::a_look, "stream");
  command->add_option("--frames", view->window.frames, "Updates after frame 0, then end")
      ->check(count())
      ->type_name("N")
      ->default_str("no end; 0 with --screenshot");
  command
      ->add_option("--screenshot", view->window.screenshot,
                   "Show no window, but write what is in it at the end as a PNG file")
      ->type_name("FILE");
  command->add_option("--width", view->window.width, "Pixels across")
      ->check(count(640, 8192))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--height", view->window.height, "Pixels down")
      ->check(count(240, 8192))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--no-panel", view->no_panel, "Begin without the panel");
  command->add_flag("--fat-boxes", view->window.stream_parts.fat_boxes, "Begin with the fat boxes of stream");
  command->add_flag("--cells", view->window.stream_parts.cells, "Begin with the cells of stream");
  auto* box = command->add_option("--box", view->box, "Begin with this box held into the world")
                  ->type_name("MINX,MINY,MINZ,MAXX,MAXY,MAXZ");
  command->add_option("--ray", view->ray, "Begin with this ray")->type_name("X,Y,Z,DX,DY,DZ")->excludes(box);
  command->add_flag("--help-keys", view->window.help, "Begin with the help of the keys");
  command->footer(
      "H shows the keys. Exit code 5 where there is no display with OpenGL 3.3.\n"
      "Examples:\n"
      "  cellsweep view --scene paper --bodies 1024 --engine cell-resident\n"
      "  cellsweep view bench/scenes/bullet-pile-1024.aabbs\n"
      "  cellsweep view --scene varied --bodies 300 --frames 50 --screenshot varied.png");
  command->callback([view, &exit_code] { exit_code = view->run(); });
}

}  // namespace cellsweep::app
