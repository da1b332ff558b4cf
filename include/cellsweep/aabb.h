/// @file
/// The axis-aligned bounding box that every engine works on.
#pragma once

#include <array>

namespace cellsweep {

/// A closed box: `min[k] <= x <= max[k]` on the axes k = 0, 1, 2 (x, y, z), in the caller's length unit.
/// A point or a sheet (min equal to max) is a valid box. 24 bytes, no padding.
struct Aabb {
  std::array<float, 3> min{};
  std::array<float, 3> max{};

  friend bool operator==(const Aabb&, const Aabb&) = default;
};

static_assert(sizeof(Aabb) == 24);

/// True when the two closed boxes share at least one point: touching counts (X5).
constexpr bool overlap(const Aabb& a, const Aabb& b) {
  return a.min[0] <= b.max[0] && b.min[0] <= a.max[0] &&  //
         a.min[1] <= b.max[1] && b.min[1] <= a.max[1] &&  //
         a.min[2] <= b.max[2] && b.min[2] <= a.max[2];
}

}  // namespace cellsweep
