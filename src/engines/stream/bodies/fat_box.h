/// @file
/// The fat box of a body: where it may be for some updates, if it keeps its course.
#pragma once

#include "cellsweep/aabb.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

/// What a fat box is made for.
struct Outlook {
  float updates = 0;      ///< in which the body keeps its course,
  bool may_turn = false;  ///< or turns back: a body that trembles
  float margin = 0;       ///< on all sides, whatever the body does
  float least = 0;        ///< the way it goes at least, in lengths of the box,
  float reach = 0;        ///< and to either side, when it may turn
};

/// A box that encloses `now` and, the way that led from `old` to it, what comes next, but no further than
/// tuning::kMostGrowth of its lengths. A box that moves further than its own length at a time does not grow
/// but for the margin.
[[gnu::noinline]] Aabb fat_box_of(const Aabb& old, const Aabb& now, const Outlook& outlook);

/// A box that encloses `now` and where the way that led from `old` to it leads to in so many updates, but no
/// further than fat_box_of().
[[gnu::cold]] Aabb course_of(const Aabb& old, const Aabb& now, float updates);

/// What a fat box is made for that will be used later.
struct LaterOutlook {
  float from = 0;     ///< it is used so many updates ahead,
  float updates = 0;  ///< for so many
  float margin = 0;   ///< on all sides
  float least = 0;    ///< the way it goes at least, in lengths of the box
};

/// A box that encloses where the way that led from `old` to `now` will lead to by then. A box that moves
/// further than its own length at a time is taken to stay.
[[gnu::noinline]] Aabb later_fat_box_of(const Aabb& old, const Aabb& now, const LaterOutlook& outlook);

/// Whether a body will have left its fat box in so many updates, on the way that led from `old` to `now`. One
/// that moves further than its own length at a time has no such way.
inline bool will_have_left(const Aabb& fat, const Aabb& old, const Aabb& now, float updates) {
  const BoxLanes around(fat), before(old), box(now);
  const Float4 edge = box.max - box.min;
  const Float4 low_step = box.min - before.min;
  const Float4 high_step = box.max - before.max;
  const Int4 is_out =
      (box.min + low_step * updates < around.min) | (box.max + high_step * updates > around.max);
  const Int4 is_near = (magnitude(low_step) <= edge) & (magnitude(high_step) <= edge);
  return on_any_axis(is_out) && on_all_axes(is_near);
}

/// Whether a body may have left its fat box on a straight way with steps like the last one, in so many
/// updates: one that goes to and fro takes longer.
[[gnu::cold]] bool may_have_kept_course(const Aabb& fat, const Aabb& old, const Aabb& now, unsigned updates);

/// How far a box moved, in its own lengths, on the axis where that is most.
float step_in_lengths(const Aabb& old, const Aabb& now);

}  // namespace cellsweep::stream
