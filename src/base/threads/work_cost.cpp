#include "base/threads/work_cost.h"

#include <algorithm>

namespace cellsweep {
namespace {

// One late thread must not change a plan.
double limited(double sample, double known) {
  return std::clamp(sample, known / 4, known * 2);
}

/// How many times as long the one takes as the other.
double ratio_of(double one, double other) {
  return std::max(one, other) / std::min(one, other);
}

}  // namespace

// Until one worker has been tried alone, it is taken to need as many times as long as there are workers. What
// takes less than the clock can tell, and nothing at all, say nothing.
void WorkCost::learn(std::chrono::duration<double> elapsed, unsigned workers, std::size_t items) {
  if (items == 0 || !(elapsed.count() > 0)) return;
  const double sample = elapsed.count() / static_cast<double>(items);
  const bool by_all = workers > 1;
  if (!by_all || !is_alone_known_) mean_ += 0.25 * (limited(sample * workers, mean_) - mean_);
  if (by_all == by_all_) note_turn(sample);
}

// In the first turn of a trial much lies where the others of before left it, and threads may have to start.
void WorkCost::note_turn(double sample) {
  ++turns_;
  double& best = by_all_ ? together_ : alone_;
  if (!is_trial_) {
    best = std::min(sample, tuning::kBestForgets * best);
    if (turns_ >= patience_) begin_trial(!by_all_);
    return;
  }
  if (turns_ == 1) return;
  best = turns_ == 2 ? sample : std::min(sample, best);
  if (!is_alone_known_ && by_all_) return begin_trial(false);
  is_alone_known_ = true;
  const double ratio = ratio_of(together_, alone_);
  const bool is_clear = ratio > tuning::kClearGain && ratio < tuning::kIncredible;
  if (is_clear || turns_ == tuning::kTurnsOfTrial) end_trial();
}

void WorkCost::begin_trial(bool by_all) {
  is_trial_ = true;
  by_all_ = by_all;
  turns_ = 0;
}

// What was clear is not soon asked again.
void WorkCost::end_trial() {
  if (!by_all_) mean_ = alone_;
  const bool all_pay = together_ < tuning::kLeastGain * alone_;
  patience_ = all_pay == by_all_ ? tuning::kLeastTurns : std::min(2 * patience_, tuning::kMostTurns);
  if (ratio_of(together_, alone_) > tuning::kClearGain)
    patience_ = std::max(patience_, tuning::kLeastTurnsOfClear);
  by_all_ = all_pay;
  is_trial_ = false;
  turns_ = 0;
}

}  // namespace cellsweep
