#include "engines/stream/bodies/fat_box.h"

#include <algorithm>
#include <cfloat>

#include "base/tuning.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

// All three axes at a time: this is asked of every body when all fat boxes are made anew.

Float4 splat(float value) {
  return Float4{value, value, value, value};
}

/// The values where a body moved no further than its own length, else 0.
Float4 where_near(Float4 step, Float4 edge, Float4 values) {
  return magnitude(step) <= edge ? values : splat(0);
}

/// How far a face may be carried by a body that keeps its course, with its sign.
Float4 carried(Float4 step, Float4 edge, float updates) {
  const Float4 most = edge * tuning::kMostGrowth;
  return smaller(larger(step * updates, -most), most);
}

/// How far a fat box reaches that way, at least a part of the length: that of a slow body is to last for
/// long.
template <class AnyOutlook>
Float4 growth(Float4 step, Float4 edge, const AnyOutlook& outlook) {
  const Float4 none = splat(0);
  const Float4 least = edge * outlook.least;
  const Float4 far = carried(step, edge, outlook.updates);
  return step > none ? larger(far, least) : step < none ? smaller(far, -least) : none;
}

/// And how far to either side by one that may turn, or by any body.
Float4 to_either_side(Float4 step, Float4 edge, const Outlook& outlook) {
  const Float4 margin = splat(outlook.margin);
  if (!outlook.may_turn) return margin;
  const Float4 wanted = larger(magnitude(step) * outlook.updates, edge * outlook.reach);
  const Float4 reach = smaller(wanted, edge * tuning::kMostTremble);
  return larger(where_near(step, edge, reach), margin);
}

Float4 within_numbers(Float4 values) {
  return smaller(larger(values, splat(-FLT_MAX)), splat(FLT_MAX));
}

/// How a box moved, and its lengths.
struct Motion {
  Motion(const Aabb& old_box, const Aabb& now_box) : now(now_box) {
    const BoxLanes old(old_box);
    edge = now.max - now.min;
    low_step = now.min - old.min;
    high_step = now.max - old.max;
  }

  BoxLanes now;
  Float4 edge;
  Float4 low_step;
  Float4 high_step;
};

}  // namespace

Aabb fat_box_of(const Aabb& old, const Aabb& now_box, const Outlook& outlook) {
  const auto [now, edge, low_step, high_step] = Motion(old, now_box);
  const Float4 low = smaller(where_near(low_step, edge, growth(low_step, edge, outlook)),
                             -to_either_side(low_step, edge, outlook));
  const Float4 high = larger(where_near(high_step, edge, growth(high_step, edge, outlook)),
                             to_either_side(high_step, edge, outlook));
  return box_of(within_numbers(smaller(now.min + low, now.min)),
                within_numbers(larger(now.max + high, now.max)));
}

Aabb course_of(const Aabb& old, const Aabb& now_box, float updates) {
  const auto [now, edge, low_step, high_step] = Motion(old, now_box);
  const Float4 low = where_near(low_step, edge, carried(low_step, edge, updates));
  const Float4 high = where_near(high_step, edge, carried(high_step, edge, updates));
  return box_of(within_numbers(smaller(now.min + low, now.min)),
                within_numbers(larger(now.max + high, now.max)));
}

// The faces of a box that shrinks may be carried beyond each other.
Aabb later_fat_box_of(const Aabb& old, const Aabb& now_box, const LaterOutlook& outlook) {
  const auto [now, edge, low_step, high_step] = Motion(old, now_box);
  const Float4 low = low_step * outlook.from + smaller(growth(low_step, edge, outlook), splat(0));
  const Float4 high = high_step * outlook.from + larger(growth(high_step, edge, outlook), splat(0));
  const Float4 slack = larger(within_numbers(edge * tuning::kSlackOfLater), splat(outlook.margin));
  const Float4 one = within_numbers(now.min + where_near(low_step, edge, low) - slack);
  const Float4 other = within_numbers(now.max + where_near(high_step, edge, high) + slack);
  return box_of(smaller(one, other), larger(one, other));
}

bool may_have_kept_course(const Aabb& fat, const Aabb& old, const Aabb& now_box, unsigned updates) {
  const auto [now, edge, low_step, high_step] = Motion(old, now_box);
  const BoxLanes around(fat);
  const Float4 room = around.max - around.min - edge;
  const Float4 step = larger(magnitude(low_step), magnitude(high_step));
  const auto most = step * static_cast<float>(updates - 1) > room;
  const auto least = step * static_cast<float>(updates) > room * tuning::kRoomOnCourse;
  return (most[0] | most[1] | most[2]) == 0 && (least[0] | least[1] | least[2]) != 0;
}

float step_in_lengths(const Aabb& old, const Aabb& now_box) {
  const auto [now, edge, low_step, high_step] = Motion(old, now_box);
  const Float4 step = larger(magnitude(low_step), magnitude(high_step));
  const Float4 lengths = step / larger(edge, splat(FLT_MIN));
  return std::max(std::max(lengths[0], lengths[1]), lengths[2]);
}

}  // namespace cellsweep::stream
