#include "base/threads/work_cost.h"

#include <algorithm>

namespace cellsweep {
namespace {

// One late thread must not change a plan.
double limited(double sample, double known) {
  return std::clamp(sample, known / 4, known * 2);
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

// In the first update of a trial much lies where the others of before left it.
void WorkCost::note_turn(double sample) {
  ++turns_;
  if (is_trial_) {
    if (turns_ > 1) tried_ += limited(sample, by_all_ ? together_ : alone_);
    if (turns_ == tuning::kTurnsOfTrial) end_trial();
  } else if (turns_ >= patience_) {
    is_trial_ = true;
    by_all_ = !by_all_;
    tried_ = 0;
    turns_ = 0;
  }
}

void WorkCost::end_trial() {
  (by_all_ ? together_ : alone_) = tried_ / (tuning::kTurnsOfTrial - 1);
  is_alone_known_ = true;
  const bool all_pay = together_ < tuning::kLeastGain * alone_;
  patience_ = all_pay == by_all_ ? tuning::kLeastTurns : std::min(2 * patience_, tuning::kMostTurns);
  by_all_ = all_pay;
  is_trial_ = false;
  turns_ = 0;
}

}  // namespace cellsweep
