/// @file
/// The values that boxes have inside: no -0, no denormals, nothing that is not finite.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstddef>

#include "cellsweep/aabb.h"

namespace cellsweep {

/// -0 and denormals become +0, so that IEEE and SPU compares agree; every other value stays as it is.
inline float canonical(float value) {
  return std::fabs(value) < FLT_MIN ? 0.0F : value;
}

/// A box of canonical values.
inline Aabb canonical(const Aabb& box) {
  Aabb result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[axis] = canonical(box.min[axis]);
    result.max[axis] = canonical(box.max[axis]);
  }
  return result;
}

/// True for finite values with min <= max on every axis.
inline bool is_valid(const Aabb& box) {
  bool valid = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // A NaN fails every comparison, so this one line refuses all there is to refuse.
    valid = valid && box.min[axis] >= -FLT_MAX && box.min[axis] <= box.max[axis] && box.max[axis] <= FLT_MAX;
  }
  return valid;
}

}  // namespace cellsweep
