/// @file
/// Takes the time of an update's steps, on the wall and of the process.
#pragma once

#include <chrono>
#include <cstddef>
#include <ctime>
#include <string_view>
#include <vector>

#include "cellsweep/ranks.h"

namespace cellsweep::ranks {

/// A stopwatch that is read at the end of each step.
class PhaseClock {
 public:
  /// What the list has room for: reading the clock takes no memory.
  static constexpr std::size_t kMostPhases = 16;

  explicit PhaseClock(std::vector<RankPhase>& phases) : phases_(phases) { phases_.clear(); }

  void lap(std::string_view name, bool is_wait = false) {
    const double now = wall();
    const double cpu_now = cpu();
    phases_.push_back({name, now - wall_, cpu_now - cpu_, is_wait});
    wall_ = now;
    cpu_ = cpu_now;
  }
  void lap_wait(std::string_view name) { lap(name, true); }

 private:
  static double wall() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }
  static double cpu() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
  }

  std::vector<RankPhase>& phases_;
  double wall_ = wall();
  double cpu_ = cpu();
};

}  // namespace cellsweep::ranks
