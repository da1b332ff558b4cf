#include "engines/stream/small_world.h"

#include <algorithm>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

std::uint64_t cost_of_fat_boxes(const FatBoxWork& work) {
  const std::uint64_t placed =
      work.is_full ? tuning::kAllPlacedCost * work.bodies : tuning::kPlacedCost * work.placed;
  return tuning::kFatBoxCost * work.bodies + placed + tuning::kCandidateCost * work.candidates;
}

std::uint64_t cost_of_sweep(const FatBoxWork& work) {
  return tuning::kSweptCost * work.bodies + tuning::kSweptPairCost * work.pairs;
}

}  // namespace

bool SmallWorld::begin_update(const BodyChanges& changes) {
  if (!may_be_swept_) return false;
  much_motion_ = has_much_motion(changes);
  if (!much_motion_) {
    is_swept_ = is_swept_ && changes.moved.empty();
    seen_ = 0;
    return false;
  }
  if (is_swept_) watch(changes);
  return is_swept_;
}

bool SmallWorld::has_much_motion(const BodyChanges& changes) const {
  return changes.boxes.size() <= tuning::kMostSweptInMotion && do_most_move(changes) &&
         !changes.moved.empty();
}

void SmallWorld::give_up() {
  try_fat_boxes();
  pause_ = tuning::kPauseOfSweeps;
}

void SmallWorld::try_fat_boxes() {
  is_swept_ = false;
  seen_ = 0;
  stays_ = 0;
  settling_ = tuning::kUpdatesOfSettling;
  judged_ = 0;
  excess_ = 0;
  lasted_ = 0;
}

// After so many updates the verdict, and anew.
void SmallWorld::watch(const BodyChanges& changes) {
  if (seen_ == 0) {
    watch_.begin(changes);
  } else if (!watch_.see(changes)) {
    seen_ = 0;
    return;
  }
  if (++seen_ < tuning::kUpdatesWatched) return;
  seen_ = 0;
  stays_ = watch_.most_stay() ? stays_ + 1 : 0;
  if (stays_ >= patience_) try_fat_boxes();
}

// Only where bodies move as much as in a world that is swept.
void SmallWorld::note(const FatBoxWork& work) {
  if (!may_be_swept_ || !much_motion_) return;
  if (pause_ > 0) {
    --pause_;
    return;
  }
  if (settling_ > 0 && work.is_full) {
    --settling_;
    return;
  }
  settling_ = 0;
  const auto swept = static_cast<std::int64_t>(cost_of_sweep(work));
  excess_ += static_cast<std::int64_t>(cost_of_fat_boxes(work)) - swept;
  if (++judged_ == tuning::kUpdatesJudged || excess_ > tuning::kMostExcess * swept) judge();
}

// Where fat boxes did not last, they are tried less soon again.
void SmallWorld::judge() {
  if (excess_ > 0) {
    is_swept_ = true;
    lasted_ = 0;
    patience_ = std::min(2 * patience_, tuning::kMostPatienceOfSweeps);
  } else if (++lasted_ == tuning::kMostPatienceOfSweeps) {
    lasted_ = 0;
    patience_ = 1;
  }
  judged_ = 0;
  excess_ = 0;
}

}  // namespace cellsweep::stream
