#include "engines/stream/bodies/watch.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace cellsweep::stream {

void Watch::begin(const BodyChanges& changes) {
  const std::size_t step = changes.moved.size() / tuning::kWatched + 1;
  count_ = 0;
  for (std::size_t i = 0; i < changes.moved.size(); i += step) {
    const Slot slot = changes.moved[i];
    Body& body = bodies_[count_++];
    body = {slot, changes.before[slot], changes.before[slot], 0};
    follow(body, changes.boxes[slot]);
  }
}

bool Watch::see(const BodyChanges& changes) {
  for (Body& body : std::span(bodies_).first(count_)) {
    const Aabb& now = changes.boxes[body.slot];
    if (!(now.min[0] <= now.max[0])) return false;
    follow(body, now);
  }
  return true;
}

bool Watch::most_stay() const {
  const auto watched = std::span(bodies_).first(count_);
  return 2 * static_cast<std::size_t>(std::count_if(watched.begin(), watched.end(), stays)) >= count_;
}

void Watch::follow(Body& body, const Aabb& now) {
  float step = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    step = std::max(step, std::abs(now.min[axis] - body.box.min[axis]));
    body.reach.min[axis] = std::min(body.reach.min[axis], now.min[axis]);
    body.reach.max[axis] = std::max(body.reach.max[axis], now.max[axis]);
  }
  body.way += step;
  body.box = now;
}

// A body that keeps its course gets as far as its way is long. One that has hardly moved at all does not
// leave its fat box soon.
bool Watch::stays(const Body& body) {
  float far = 0;
  bool has_moved = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float length = body.box.max[axis] - body.box.min[axis];
    const float more = body.reach.max[axis] - body.reach.min[axis] - length;
    far = std::max(far, more);
    has_moved = has_moved || more > length * tuning::kHardlyMoved;
  }
  return !has_moved || 2 * far <= body.way;
}

}  // namespace cellsweep::stream
