/// @file
/// What is wrong with a box, in words.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "base/text.h"
#include "cellsweep/aabb.h"

namespace cellsweep {

/// Of a box that is not valid: a part of a sentence.
[[gnu::cold]] inline std::string describe_fault(const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float low = box.min[axis];
    const float high = box.max[axis];
    const char name = "xyz"[axis];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      return text("its ", name, " interval [", low, ", ", high, "] is not finite");
    }
    if (low > high) return text("its minimum on ", name, ", ", low, ", is above its maximum, ", high);
  }
  return {};
}

}  // namespace cellsweep
