/// @file
/// What every engine does to its input before anything is applied: make values canonical, refuse bad ones.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// −0 and denormals become +0, so that IEEE and SPU compares agree; every other value stays as it is.
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

/// The status that names what is wrong with a box that is not valid.
Status invalid_box_status(BodyId body, const Aabb& box);

/// The status for spans that should be equally long.
Status length_status(std::size_t ids, std::size_t boxes);

/// The first id, in ascending order, that occurs twice; nothing when all differ.
std::optional<BodyId> find_duplicate(std::span<const BodyId> ids);

Status unknown_body_status(BodyId body);
Status duplicate_body_status(BodyId body, const char* where);

}  // namespace cellsweep
