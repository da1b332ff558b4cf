/// @file
/// The six numbers of a box, read without a call of std::array's members: body.h says why.
#pragma once

#include <cstddef>
#include <type_traits>

#include "cellsweep/aabb.h"

namespace cellsweep::stream {

static_assert(std::is_standard_layout_v<Aabb> && sizeof(Aabb) == 6 * sizeof(float));
static_assert(offsetof(Aabb, max) == 3 * sizeof(float));

namespace {

/// Minimum x, y, z, maximum x, y, z.
inline const float* faces_of(const Aabb& box) {
  return reinterpret_cast<const float*>(&box);
}

}  // namespace
}  // namespace cellsweep::stream
