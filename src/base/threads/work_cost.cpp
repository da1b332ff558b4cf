#include "base/threads/work_cost.h"

#include <algorithm>

namespace cellsweep {
namespace {

// One late thread must not change a plan.
double limited(double sample, double known) {
  return std::clamp(sample, known / 4, known * 2);
}

bool differ_clearly(double one, double other) {
  return std::max(one, other) > tuning::kClearGain * std::min(one, other);
}

void approach(double& known, double sample) {
  known += 0.25 * (limited(sample, known) - known);
}

}  // namespace

// Until one worker has been tried alone, it is taken to need as many times as long as there are workers. What
// takes less than the clock can tell, and nothing at all, say nothing.
void WorkCost::learn(std::chrono::duration<double> elapsed, unsigned workers, std::size_t items) {
  if (items == 0 || !(elapsed.count() > 0)) return;
  const double sample = elapsed.count() / static_cast<double>(items);
  const bool by_all = workers > 1;
  if (by_all && together_ == 0) together_ = sample;
  if (by_all) approach(together_, sample);
  if (!by_all || !is_alone_known_) approach(alone_, sample * workers);
  if (by_all == by_all_) note_turn(sample);
}

// In the first turn of a trial much lies where the others of before left it, and threads may have to start.
void WorkCost::note_turn(double sample) {
  ++turns_;
  if (!is_trial_) {
    if (turns_ >= patience_) begin_trial(!by_all_);
    return;
  }
  if (turns_ == 1) return;
  if (by_all_ && !is_alone_known_) {
    together_ = std::min(together_, sample);
    return begin_trial(false);
  }
  const double credible = limited(sample, by_all_ ? together_ : alone_);
  tried_ += credible;
  const double mean = tried_ / (turns_ - 1);
  const bool is_clear = credible == sample && differ_clearly(mean, by_all_ ? alone_ : together_);
  if (is_clear || turns_ == tuning::kTurnsOfTrial) end_trial(mean);
}

void WorkCost::begin_trial(bool by_all) {
  is_trial_ = true;
  by_all_ = by_all;
  tried_ = 0;
  turns_ = 0;
}

// What was clear is not soon asked again.
void WorkCost::end_trial(double mean) {
  (by_all_ ? together_ : alone_) = mean;
  is_alone_known_ = true;
  const bool all_pay = together_ < tuning::kLeastGain * alone_;
  patience_ = all_pay == by_all_ ? tuning::kLeastTurns : std::min(2 * patience_, tuning::kMostTurns);
  if (differ_clearly(together_, alone_)) patience_ = std::max(patience_, tuning::kLeastTurnsOfClear);
  by_all_ = all_pay;
  is_trial_ = false;
  turns_ = 0;
}

}  // namespace cellsweep
