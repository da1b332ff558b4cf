#include "engines/stream/bodies/hull.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace cellsweep::stream {
namespace {

/// How much of its own length a box may grow on an axis.
constexpr float kMostGrowth = 0.5F;

float growth(float from, float to, float edge, float updates) {
  const float step = to - from;
  if (!(std::fabs(step) <= edge)) return 0;
  return std::clamp(step * updates, -kMostGrowth * edge, kMostGrowth * edge);
}

}  // namespace

Aabb hull_of(const Aabb& old, const Aabb& now, float updates) {
  Aabb hull = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float edge = now.max[axis] - now.min[axis];
    const float low = now.min[axis] + growth(old.min[axis], now.min[axis], edge, updates);
    const float high = now.max[axis] + growth(old.max[axis], now.max[axis], edge, updates);
    hull.min[axis] = std::max(std::min(low, now.min[axis]), -FLT_MAX);
    hull.max[axis] = std::min(std::max(high, now.max[axis]), FLT_MAX);
  }
  return hull;
}

}  // namespace cellsweep::stream
