#include <filesystem>

#include "app/checks.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/setting_flags.h"
#include "base/text.h"
#include "report/experiment/experiment_page.h"
#include "report/experiment/findings.h"
#include "report/folder_lock.h"
#include "report/gnuplot.h"
#include "report/interrupt.h"

namespace cellsweep::app {
namespace {

constexpr std::size_t kQuickFrames = 60;
constexpr unsigned kQuickRepetitions = 2;
constexpr unsigned kMostRepetitions = 1'000'000;
constexpr std::size_t kSimulatedFrames = 50;
constexpr std::size_t kQuickSimulatedFrames = 10;
constexpr std::size_t kQuickSimulatedBodies = 256;

struct ExperimentCommand {
  report::ExperimentSettings settings;
  std::filesystem::path out;
  bool quick = false;
  bool frames_given = false;
  bool repetitions_given = false;

  ExitCode run() {
    if (quick && !frames_given) settings.frames = kQuickFrames;
    if (quick && !repetitions_given) settings.repetitions = kQuickRepetitions;
    settings.simulated_frames = quick ? kQuickSimulatedFrames : kSimulatedFrames;
    if (quick) settings.simulated_most_bodies = kQuickSimulatedBodies;
    if (const Status status = report::find_gnuplot(); !status.ok()) return complain(status);
    report::FolderLock folder;
    if (const Status status = folder.take(out); !status.ok()) return complain(status);
    const report::InterruptScope interrupts;
    const auto results = report::run_experiment(settings);
    if (!results) return complain(results.status());
    const Status drawn = draw(*results);
    const std::filesystem::path picture = drawn.ok() ? out / "scene.png" : "";
    if (const Status status = report::write_experiment(*results, out, picture); !status.ok())
      return complain(status);
    print(*results, drawn);
    return end_with(results->wrong.empty() ? kGood : kResultsDiffer,
                    "The page shows what was measured by then.");
  }

 private:
  // The picture takes seconds, which somebody who pressed Ctrl-C would rather not wait.
  Status draw(const report::ExperimentResults& results) const {
    if (report::is_interrupted()) return Status::bad_input("It was not drawn any more.");
    return report::draw_scene(results.settings, quick, out / "scene.png");
  }

  void print(const report::ExperimentResults& results, const Status& drawn) const {
    for (const report::Finding& finding : report::judge(results)) {
      print_text(
          text(finding.claim, "\n  ", report::verdict_text(finding.verdict), ". ", finding.text, "\n\n"));
    }
    if (!results.interrupted.empty()) print_text(results.interrupted + "\n");
    for (const std::string& sentence : results.left_out) print_text(with_flags(sentence) + "\n");
    for (const std::string& sentence : results.wrong) print_text(with_flags(sentence) + "\n");
    if (!drawn.ok()) print_text("The page is without a picture. " + drawn.message + "\n");
    print_text(
        text("The page: ", std::filesystem::absolute(out / "report.html").lexically_normal().string(), "\n"));
  }
};

}  // namespace

void add_experiment(CLI::App& program, ExitCode& exit_code) {
  CLI::App* command = program.add_subcommand(
      "experiment",
      "Measure engines at several sizes: figures, their numbers, and a page that tells what of the "
      "document's experiment holds");
  auto experiment = std::make_shared<ExperimentCommand>();
  auto& settings = experiment->settings;
  command->add_option("--out", experiment->out, "Folder for report.html, CSV, SVG and PNG files")
      ->type_name("FOLDER")
      ->required();
  command->add_flag(
      "--quick", experiment->quick,
      "60 frames, 2 repetitions, the simulated Cell with up to 256 boxes: within 20 seconds, and less exact");
  command->add_option("--bodies", settings.bodies, "Numbers of boxes, separated by commas")
      ->delimiter(',')
      ->check(count())
      ->type_name("N[,N...]")
      ->capture_default_str();
  auto* frames = command->add_option("--frames", settings.frames, "Frames of each kind")
                     ->check(count())
                     ->type_name("N")
                     ->capture_default_str();
  auto* repetitions =
      command->add_option("--repetitions", settings.repetitions, "Times that every engine takes its turn")
          ->check(count(0, kMostRepetitions))
          ->type_name("N")
          ->capture_default_str();
  command->add_option("--seed", settings.seed, "Seed of the scene")
      ->check(count())
      ->type_name("N")
      ->capture_default_str();
  command->footer(
      "Takes a minute and a half on an idle machine; what else runs there is in the\n"
      "times. Ctrl-C ends it with a page of what was measured by then.\n"
      "Examples:\n"
      "  cellsweep experiment --out results\n"
      "  cellsweep experiment --out results --quick --bodies 64,1024,3500");
  command->callback([experiment, frames, repetitions, &exit_code] {
    experiment->frames_given = frames->count() > 0;
    experiment->repetitions_given = repetitions->count() > 0;
    exit_code = experiment->run();
  });
}

}  // namespace cellsweep::app
