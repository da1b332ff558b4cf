/// @file
/// Random worlds on all engines against the oracle for as long as one likes; goes on where it was stopped.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

#include "base/text.h"
#include "cellsweep/engine/new_file.h"
#include "held.h"
#include "report/interrupt.h"
#include "soak/lives.h"

namespace cellsweep::soak {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kBetweenLines = std::chrono::seconds(10);
/// Lives before memory must be as large as it gets, and by how much it may be larger all the same.
constexpr std::uint64_t kLivesToWarmUp = 2000;
constexpr std::size_t kMoreKilobytes = std::size_t{256} << 10;

/// What has been done, in this run and those before it.
struct Totals {
  std::uint64_t next_seed = 1;
  std::uint64_t updates = 0;
  std::uint64_t pairs = 0;
  double hours = 0;
};

Totals read(const std::string& path) {
  Totals totals;
  std::ifstream file(path);
  Totals found;
  if (file >> found.next_seed >> found.updates >> found.pairs >> found.hours) totals = found;
  return totals;
}

Status write(const std::string& path, const Totals& totals) {
  return write_new_file(
      path, text(totals.next_seed, " ", totals.updates, " ", totals.pairs, " ", totals.hours, "\n"));
}

class Soak {
 public:
  /// Without a path nothing is remembered.
  Soak(std::string path, double hours, std::uint64_t worlds, std::string engine)
      : path_(std::move(path)),
        engine_(std::move(engine)),
        totals_(read(path_)),
        hours_before_(totals_.hours),
        hours_(hours),
        worlds_(worlds) {}

  /// 0, or 1 when an engine was wrong or the process grew.
  int run() {
    bool good = true;
    while (good && lives_ < worlds_ && hours_so_far() < hours_ && !report::is_interrupted()) {
      good = live_once();
      if (good && Clock::now() - last_line_ >= kBetweenLines) good = tell();
    }
    return tell() && good ? 0 : 1;
  }

 private:
  double hours_so_far() const {
    return std::chrono::duration<double, std::ratio<3600>>(Clock::now() - begin_).count();
  }

  bool live_once() {
    const Outcome outcome = live(totals_.next_seed, engine_);
    if (!outcome.failure.empty()) {
      std::cerr << "seed " << totals_.next_seed << ", " << outcome.story << ": " << outcome.failure
                << "\nAgain: cellsweep_soak --seed " << totals_.next_seed
                << (engine_.empty() ? "" : " --engine " + engine_) << '\n';
      return false;
    }
    ++totals_.next_seed;
    totals_.updates += outcome.updates;
    totals_.pairs += outcome.pairs;
    return ++lives_ < kLivesToWarmUp || is_flat();
  }

  // Engines that were destroyed leave nothing behind. Looked at now and then: to ask takes as long as a life.
  bool is_flat() {
    if (lives_ % kLivesToWarmUp != 0) return true;
    const Held now;
    if (lives_ == kLivesToWarmUp) warm_ = now;
    const bool flat = now.files <= warm_.files && now.threads <= warm_.threads + kThreadsOfLibraries &&
                      now.kilobytes <= warm_.kilobytes + kMoreKilobytes;
    if (!flat) {
      std::cerr << text("The process has grown: ", now.kilobytes / 1024, " MB, ", now.threads, " threads, ",
                        now.files, " files; after its first ", kLivesToWarmUp, " worlds ",
                        warm_.kilobytes / 1024, " MB, ", warm_.threads, ", ", warm_.files, ".\n");
    }
    return flat;
  }

  bool tell() {
    last_line_ = Clock::now();
    totals_.hours = hours_before_ + hours_so_far();
    const Held now;
    std::printf(
        "%.1f minutes: %llu worlds, %llu updates, %llu pairs compared, none wrong; %zu MB, %zu files\n",
        60 * totals_.hours, static_cast<unsigned long long>(totals_.next_seed - 1),
        static_cast<unsigned long long>(totals_.updates), static_cast<unsigned long long>(totals_.pairs),
        now.kilobytes / 1024, now.files);
    std::fflush(stdout);
    const Status status = path_.empty() ? Status() : write(path_, totals_);
    if (!status.ok()) std::cerr << status.message << '\n';
    return status.ok();
  }

  /// Embree and TBB start theirs when they like.
  static constexpr std::size_t kThreadsOfLibraries = 8;

  std::string path_;
  std::string engine_;
  Totals totals_;
  double hours_before_;
  double hours_;
  std::uint64_t worlds_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_line_ = begin_;
  std::uint64_t lives_ = 0;
  Held warm_;
};

int repeat(std::uint64_t seed, const std::string& engine) {
  const Outcome outcome = live(seed, engine);
  std::cout << outcome.story << ": " << (outcome.failure.empty() ? "right" : outcome.failure) << '\n';
  return outcome.failure.empty() ? 0 : 1;
}

}  // namespace
}  // namespace cellsweep::soak

int main(int argc, char** argv) {
  CLI::App program(
      "Random worlds on all engines against all-against-all, for hours; goes on where it was stopped",
      "cellsweep_soak");
  double hours = 1.0 / 6;
  std::string state = "soak-state.txt";
  std::uint64_t worlds = ~std::uint64_t{0};
  std::uint64_t seed = 0;
  std::string engine;
  program.add_option("HOURS", hours, "How long, ten minutes unless told")->check(CLI::Range(0.0, 10000.0));
  program.add_option("--state", state, "Where it writes how far it is, and goes on from")
      ->capture_default_str();
  program.add_option("--worlds", worlds, "No more worlds than this")->type_name("N");
  program.add_option("--seed", seed, "Only this world, once more");
  program.add_option("--engine", engine, "Only worlds of this engine, as `cellsweep engines` names it")
      ->check([](const std::string& name) {
        return cellsweep::soak::is_engine(name) ? "" : "there is no engine " + name;
      });
  program.footer(
      "Examples:\n  cellsweep_soak 8\n  cellsweep_soak --seed 4711\n  cellsweep_soak --engine stream "
      "--worlds 500 --state ''");
  CLI11_PARSE(program, argc, argv);
  if (seed != 0) return cellsweep::soak::repeat(seed, engine);
  const cellsweep::report::InterruptScope stops;
  return cellsweep::soak::Soak(state, hours, worlds, engine).run();
}
