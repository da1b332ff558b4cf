/// @file
/// `cellsweep-ranks`: a scene or a recording over the ranks of an MPI job.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/checks.h"
#include "app/engine_flags.h"
#include "app/frame_flags.h"
#include "app/help_format.h"
#include "app/output.h"
#include "app/process.h"
#include "app/ranks/rank_report.h"
#include "app/ranks/rank_run.h"
#include "app/scene_flags.h"
#include "base/text.h"
#include "cellsweep/engine/new_file.h"
#include "cellsweep/world/frame_file.h"
#include "report/all_engines.h"
#include "report/build_context.h"
#include "report/progress.h"

namespace cellsweep::app {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  mpirun -n 4 cellsweep-ranks --scene uniform --bodies 100000 --moving 1\n"
    "  mpirun -n 4 cellsweep-ranks --scene ragdolls --bodies 6000 --verify --json\n"
    "  mpirun -n 2 cellsweep-ranks bench/scenes/bullet-pile-1024.aabbs\n"
    "  mpirun -n 4 cellsweep-ranks --frames 50 --checkpoint world.h5\n"
    "  mpirun -n 3 cellsweep-ranks --frames 100 --restart world.h5\n"
    "Exit codes: those of cellsweep --help.";

int own_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int all_ranks() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

class RanksProgram {
 public:
  RanksProgram() {
    program_.formatter(std::make_shared<HelpFormat>());
    program_.set_version_flag("--version", report::version_text(), "Print the version and exit");
    CLI::Option* file =
        program_.add_option("FILE", file_, "A recording in the scene's place: .aabbs, .npy, or a .npz trace");
    scene_.add_to(program_);
    scene_.add_filters_to(program_);
    frames_.add_to(program_, 100, "100, or all that a recording has");
    add_rank_flags();
    engines_.add_to(program_, EngineFlags::Purpose::verdicts, "stream");
    SceneFlags::exclude_beside(program_, *file);
    program_.footer(kFooter);
  }

  int run(int argc, char** argv) {
    try {
      program_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (own_rank() != 0) return error.get_exit_code() == 0 ? kGood : kBadUsage;
      if (error.get_exit_code() == 0) return program_.exit(error);
      say(error.what());
      return kBadUsage;
    }
    return run_frames();
  }

 private:
  void add_rank_flags() {
    program_
        .add_option("--recut-above", settings_.ranks.recut_above,
                    "Cut the world anew when a rank has so many times the mean")
        ->check(number(1, 1e9))
        ->type_name("FACTOR")
        ->capture_default_str();
    program_.add_option("--recut-every", settings_.ranks.recut_every, "And every N updates; 0 never")
        ->check(count(0, 1'000'000'000))
        ->type_name("N")
        ->capture_default_str();
    program_.add_flag("--verify", settings_.verify,
                      "Compare each frame with one engine, on the first rank; exit code 1 when they differ");
    CLI::Option* checkpoint =
        program_.add_option("--checkpoint", settings_.checkpoint, "Write the world to this file, at the end")
            ->type_name("FILE");
    program_
        .add_option("--checkpoint-every", settings_.checkpoint_every, "And after every N frames; 0 never")
        ->check(count(0, 1'000'000'000))
        ->type_name("N")
        ->needs(checkpoint)
        ->capture_default_str();
    program_
        .add_option("--restart", settings_.restart,
                    "Go on from a checkpoint of the same scene or recording, on any number of ranks")
        ->type_name("FILE");
    program_.add_option("--timeline", timeline_, "Write what each rank did when; opens in Perfetto")
        ->type_name("FILE");
  }

  Result<std::unique_ptr<FrameSource>> make_source() {
    if (file_.empty()) return make_scene_frames(scene_.settings);
    const auto file = read_frame_file(file_);
    if (!file) return file.status();
    return file->make_source();
  }

  // Ranks are what there is one of for each processor: engines that have threads get one, unless told.
  Status choose_engine() {
    if (Status status = engines_.check(); !status.ok()) return status;
    const std::vector<std::string> names = engines_.names();
    if (names.size() != 1) {
      return Status::bad_option(
          "engine", text("--engine names ", names.size(), " engines; the ranks of a job have one kind."));
    }
    settings_.ranks.make_engine = [name = names.front(), values = engines_.values()] {
      SettingValues settings = values;
      const bool said =
          std::ranges::any_of(values, [](const auto& value) { return value.first == "threads"; });
      if (name == "stream" && !said) settings.emplace_back("threads", "1");
      return make_broadphase(name, settings);
    };
    return {};
  }

  ExitCode run_frames() {
    const bool all_frames = !file_.empty() && program_.count("--frames") == 0;
    settings_.updates = all_frames ? report::Progress::kOpenEnd : frames_.settings.updates;
    settings_.report_frames = frames_.settings.report_frames;
    settings_.timeline = !timeline_.empty();
    if (Status status = choose_engine(); !status.ok()) return complain_once(status);
    auto source = make_source();
    // A file may be missing on one machine alone; the others must not wait for its rank.
    int failed = source ? 0 : all_ranks() - own_rank();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    if (failed > 0 && failed != all_ranks() - own_rank()) return kBadUsage;
    if (!source) return complain(source.status());
    const auto report = run_on_ranks(**source, settings_);
    if (!report) return complain_once(report.status());
    return own_rank() == 0 ? tell((*source)->name(), *report) : verdict(*report);
  }

  ExitCode tell(const std::string& source, const RankReport& report) {
    if (!timeline_.empty()) {
      if (Status status = write_new_file(timeline_, rank_timeline(report)); !status.ok())
        return complain(status);
    }
    nlohmann::ordered_json json = rank_json(source, report);
    if (settings_.verify) json["verified"] = report.differing_frames == 0;
    if (frames_.json) {
      print_json(json);
    } else {
      print_text(rank_tables(source, report));
      if (settings_.verify && report.differing_frames == 0)
        print_text(text("\nThe same as one engine in all ", report.updates + 1, " frames.\n"));
    }
    if (report.differing_frames > 0)
      say(text("In ", report.differing_frames, " frames the ranks differ from one engine. ",
               report.first_difference));
    return verdict(report);
  }

  static ExitCode verdict(const RankReport& report) {
    return report.differing_frames == 0 ? kGood : kResultsDiffer;
  }

  // All ranks have the same to say.
  static ExitCode complain_once(const Status& status) {
    return own_rank() == 0 ? complain(status) : exit_code_of(status);
  }

  CLI::App program_{"A scene or a recording over the ranks of an MPI job.", "cellsweep-ranks"};
  std::string file_;
  std::string timeline_;
  SceneFlags scene_;
  FrameFlags frames_;
  EngineFlags engines_;
  RankRunSettings settings_;
};

}  // namespace
}  // namespace cellsweep::app

int main(int argc, char** argv) {
  using namespace cellsweep::app;
  prepare_process();
  MPI_Init(&argc, &argv);
  cellsweep::report::add_all_engines();
  int code = kBadUsage;
  try {
    code = RanksProgram().run(argc, argv);
    if (own_rank() == 0) code = end_of_program(code);
  } catch (const std::exception& error) {
    if (is_want_of_memory(error)) end_without_memory();
    say(error.what());
  }
  MPI_Finalize();
  return code;
}
