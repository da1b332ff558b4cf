#include "engines/stream/small_world.h"

#include "base/tuning.h"

namespace cellsweep::stream {

bool SmallWorld::begin_update(const BodyChanges& changes) {
  if (!may_be_swept_) return false;
  much_motion_ = has_much_motion(changes);
  if (rests_ > 0) --rests_;
  if (!much_motion_) {
    is_swept_ = is_swept_ && changes.moved.empty();
    seen_ = 0;
    return false;
  }
  if (is_swept_) watch(changes);
  return is_swept_;
}

bool SmallWorld::has_much_motion(const BodyChanges& changes) const {
  return changes.boxes.size() <= tuning::kMostSweptInMotion && 2 * changes.moved.size() >= changes.bodies &&
         !changes.moved.empty();
}

void SmallWorld::note_full() {
  if (may_be_swept_ && much_motion_ && rests_ == 0) is_swept_ = true;
}

void SmallWorld::give_up() {
  is_swept_ = false;
  seen_ = 0;
  rests_ = tuning::kTrialOfFatBoxes;
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
  if (watch_.most_stay()) give_up();
}

}  // namespace cellsweep::stream
