/// @file
/// The box around boxes.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cstddef>

#include "cellsweep/aabb.h"

namespace cellsweep {

class Bounds {
 public:
  void include(const Aabb& box) {
    any_ = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box_.min[axis] = std::min(box_.min[axis], box.min[axis]);
      box_.max[axis] = std::max(box_.max[axis], box.max[axis]);
    }
  }

  bool empty() const { return !any_; }
  /// Around none, the point at the origin.
  Aabb box() const { return any_ ? box_ : Aabb{}; }

 private:
  Aabb box_{{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
  bool any_ = false;
};

}  // namespace cellsweep
