#include "engines/stream/bodies/fat_box.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

float growth(float from, float to, float edge, float updates) {
  const float step = to - from;
  if (!(std::fabs(step) <= edge)) return 0;
  return std::clamp(step * updates, -tuning::kMostGrowth * edge, tuning::kMostGrowth * edge);
}

}  // namespace

Aabb fat_box_of(const Aabb& old, const Aabb& now, float updates) {
  Aabb fat = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float edge = now.max[axis] - now.min[axis];
    const float low = now.min[axis] + growth(old.min[axis], now.min[axis], edge, updates);
    const float high = now.max[axis] + growth(old.max[axis], now.max[axis], edge, updates);
    fat.min[axis] = std::max(std::min(low, now.min[axis]), -FLT_MAX);
    fat.max[axis] = std::min(std::max(high, now.max[axis]), FLT_MAX);
  }
  return fat;
}

}  // namespace cellsweep::stream
