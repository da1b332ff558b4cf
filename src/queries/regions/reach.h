/// @file
/// What a region reaches.
#pragma once

#include <cstddef>

#include "cellsweep/query.h"
#include "queries/outward.h"
#include "queries/regions/region_box.h"

namespace cellsweep::queries {

/// A region, canonical, and a box around it.
class Reach {
 public:
  explicit Reach(const Region& region) : box_(region.box), around_(box_), distance_(region.distance) {
    if (distance_ != 0) around_ = RegionBox(box_around(box_.box(), distance_));
  }

  const Aabb& box() const { return box_.box(); }
  double distance() const { return distance_; }
  const RegionBox& around() const { return around_; }

 private:
  static Aabb box_around(const Aabb& box, double distance) {
    // A distance that is computed may be less than the true one by a few roundings of it.
    const double most = distance * (1 + 0x1p-50);
    Aabb around;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      around.min[axis] = below(box.min[axis] - most);
      around.max[axis] = above(box.max[axis] + most);
    }
    return around;
  }

  RegionBox box_;
  RegionBox around_;
  double distance_;
};

}  // namespace cellsweep::queries
