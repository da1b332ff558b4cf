/// @file
/// The box around boxes.
#pragma once

#include <cfloat>
#include <cstddef>

#include "cellsweep/aabb.h"
#include "geometry/box_lanes.h"

namespace cellsweep {

class Bounds {
 public:
  void include(const Aabb& box) {
    const BoxLanes lanes(box);
    min_ = lanes.min < min_ ? lanes.min : min_;
    max_ = lanes.max > max_ ? lanes.max : max_;
    any_ = true;
  }

  bool empty() const { return !any_; }
  /// Around none, the point at the origin.
  Aabb box() const {
    Aabb box;
    if (!any_) return box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = min_[axis];
      box.max[axis] = max_[axis];
    }
    return box;
  }

 private:
  Float4 min_ = Float4{} + FLT_MAX;
  Float4 max_ = Float4{} - FLT_MAX;
  bool any_ = false;
};

}  // namespace cellsweep
