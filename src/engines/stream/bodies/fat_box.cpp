#include "engines/stream/bodies/fat_box.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// How far a face may be carried by a body that keeps its course, with its sign.
float growth(float step, float edge, float updates) {
  if (!(std::fabs(step) <= edge)) return 0;
  return std::clamp(step * updates, -tuning::kMostGrowth * edge, tuning::kMostGrowth * edge);
}

/// And how far to either side by one that trembles.
float tremble(float step, float edge, float updates) {
  if (!(std::fabs(step) <= edge)) return 0;
  return std::min(std::fabs(step) * updates, tuning::kMostTremble * edge);
}

}  // namespace

Aabb fat_box_of(const Aabb& old, const Aabb& now, const Outlook& outlook) {
  Aabb fat = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float edge = now.max[axis] - now.min[axis];
    const float low_step = now.min[axis] - old.min[axis];
    const float high_step = now.max[axis] - old.max[axis];
    const float low_turn = outlook.may_turn ? tremble(low_step, edge, outlook.updates) : 0;
    const float high_turn = outlook.may_turn ? tremble(high_step, edge, outlook.updates) : 0;
    const float low = std::min(growth(low_step, edge, outlook.updates), -std::max(low_turn, outlook.margin));
    const float high =
        std::max(growth(high_step, edge, outlook.updates), std::max(high_turn, outlook.margin));
    fat.min[axis] = std::max(std::min(now.min[axis] + low, now.min[axis]), -FLT_MAX);
    fat.max[axis] = std::min(std::max(now.max[axis] + high, now.max[axis]), FLT_MAX);
  }
  return fat;
}

bool is_short_step(const Aabb& old, const Aabb& now) {
  bool is_short = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float most = (now.max[axis] - now.min[axis]) * tuning::kMostTremble;
    is_short = is_short && std::fabs(now.min[axis] - old.min[axis]) <= most &&
               std::fabs(now.max[axis] - old.max[axis]) <= most;
  }
  return is_short;
}

}  // namespace cellsweep::stream
