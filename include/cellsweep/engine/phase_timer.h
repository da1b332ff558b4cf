/// @file
/// Takes the time of an engine's steps for its statistics and its timeline.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/engine/timeline.h"
#include "cellsweep/statistics.h"

namespace cellsweep {

/// A stopwatch that is read at the end of each step.
class PhaseTimer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit PhaseTimer(std::vector<Phase>& phases) : phases_(phases) { phases_.clear(); }

  /// Everything since the last call, or since construction, was the step of this name. Not inlined: what a
  /// timeline needs would be in a program once for each step.
  [[gnu::noinline]] void lap(std::string_view name, PhaseKind kind = PhaseKind::work) {
    const Clock::time_point now = Clock::now();
    if (const TimelineRow* row = TimelineRow::current())
      row->timeline->add(row->number, std::string(name), last_, now);
    phases_.push_back({name, std::chrono::duration<double, std::milli>(now - last_).count(), kind});
    last_ = now;
  }

  /// When the last step ended.
  Clock::time_point last() const { return last_; }

 private:
  std::vector<Phase>& phases_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace cellsweep
