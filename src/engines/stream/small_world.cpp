#include "engines/stream/small_world.h"

#include <algorithm>
#include <cmath>

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

void SmallWorld::watch(const BodyChanges& changes) {
  if (seen_ == 0) begin_to_watch(changes);
  if (!see(changes)) {
    seen_ = 0;
    return;
  }
  if (++seen_ < tuning::kUpdatesWatched) return;
  seen_ = 0;
  if (most_stay()) give_up();
}

void SmallWorld::begin_to_watch(const BodyChanges& changes) {
  const std::size_t step = changes.moved.size() / tuning::kWatched + 1;
  watched_count_ = 0;
  for (std::size_t i = 0; i < changes.moved.size(); i += step) {
    const Slot slot = changes.moved[i];
    watched_[watched_count_++] = {slot, changes.before[slot], changes.before[slot], 0};
  }
}

// False when one of them is not there any more, or is another.
bool SmallWorld::see(const BodyChanges& changes) {
  for (std::size_t i = 0; i < watched_count_; ++i) {
    Watched& body = watched_[i];
    const Aabb& now = changes.boxes[body.slot];
    if (!(now.min[0] <= now.max[0])) return false;
    float step = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      step = std::max(step, std::abs(now.min[axis] - body.box.min[axis]));
      body.reach.min[axis] = std::min(body.reach.min[axis], now.min[axis]);
      body.reach.max[axis] = std::max(body.reach.max[axis], now.max[axis]);
    }
    body.way += step;
    body.box = now;
  }
  return true;
}

// A body that keeps its course gets as far as its way is long; one that trembles goes to and fro.
bool SmallWorld::most_stay() const {
  std::size_t stay = 0;
  for (std::size_t i = 0; i < watched_count_; ++i) {
    const Watched& body = watched_[i];
    float far = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float length = body.box.max[axis] - body.box.min[axis];
      far = std::max(far, body.reach.max[axis] - body.reach.min[axis] - length);
    }
    stay += 2 * far <= body.way ? 1 : 0;
  }
  return 2 * stay > watched_count_;
}

}  // namespace cellsweep::stream
