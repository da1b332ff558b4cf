/// @file
/// Fat boxes: with a margin on all sides, in which a body may move before anybody is told of it.
#pragma once

#include <LinearMath/btVector3.h>
#include <cellsweep/aabb.h>

#include <limits>

#include "proxy_box.h"

/// No box is within NaN.
inline constexpr cellsweep::Aabb kHoldsNothing = [] {
  cellsweep::Aabb box;
  box.min.fill(std::numeric_limits<float>::quiet_NaN());
  return box;
}();

inline cellsweep::Aabb fat_box_of(const btVector3& low, const btVector3& high, btScalar margin) {
  const btVector3 more(margin, margin, margin);
  return box_of(low - more, high + more);
}

/// Without a branch for each number: one or the other is often not held.
inline bool holds(const cellsweep::Aabb& fat, const btVector3& low, const btVector3& high) {
  const auto is_before = [](btScalar one, btScalar other) { return one <= other ? 1U : 0U; };
  return (is_before(fat.min[0], low.x()) & is_before(high.x(), fat.max[0]) & is_before(fat.min[1], low.y()) &
          is_before(high.y(), fat.max[1]) & is_before(fat.min[2], low.z()) &
          is_before(high.z(), fat.max[2])) != 0;
}
