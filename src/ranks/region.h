/// @file
/// The part of space that belongs to a rank, open below and closed above, so that each point is in one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "cellsweep/aabb.h"
#include "cellsweep/query.h"

namespace cellsweep::ranks {

/// All points with above < x <= up_to on each axis.
struct Region {
  Point above{};
  Point up_to{};
};

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// All of space.
inline constexpr Region kEverywhere{{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};

/// No point, and no box reaches it.
inline constexpr Region kNowhere{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

inline bool holds(const Region& region, const Point& point) {
  bool holds = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    holds = holds && point[axis] > region.above[axis] && point[axis] <= region.up_to[axis];
  return holds;
}

/// Whether the box has a point in the region.
inline bool reaches(const Region& region, const Aabb& box) {
  bool reaches = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    reaches = reaches && box.max[axis] > region.above[axis] && box.min[axis] <= region.up_to[axis];
  return reaches;
}

/// Whether all points of the box are in the region: it reaches no other.
inline bool encloses(const Region& region, const Aabb& box) {
  bool encloses = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    encloses &= box.min[axis] > region.above[axis];
    encloses &= box.max[axis] <= region.up_to[axis];
  }
  return encloses;
}

/// The lower corner of what two boxes share that overlap: the region that holds it owns their pair.
inline Point lower_corner(const Aabb& one, const Aabb& other) {
  return {std::max(one.min[0], other.min[0]), std::max(one.min[1], other.min[1]),
          std::max(one.min[2], other.min[2])};
}

}  // namespace cellsweep::ranks
