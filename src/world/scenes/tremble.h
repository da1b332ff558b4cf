/// @file
/// How bodies at rest tremble, as those of a solver do that never quite comes to an end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"
#include "world/random.h"

namespace cellsweep {

using Offset = std::array<double, 3>;

/// How far a body is from its place in this frame: anywhere within −reach to reach on each axis.
inline Offset tremble(std::uint64_t seed, BodyId id, std::size_t frame, double reach) {
  Random random(seed + id, frame);
  Offset offset{};
  for (double& x : offset) x = random.between(-reach, reach);
  return offset;
}

/// The box so far from its place, each corner rounded once.
inline Aabb shifted(const Aabb& box, const Offset& offset) {
  Aabb result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[axis] = static_cast<float>(static_cast<double>(box.min[axis]) + offset[axis]);
    result.max[axis] = static_cast<float>(static_cast<double>(box.max[axis]) + offset[axis]);
  }
  return result;
}

}  // namespace cellsweep
