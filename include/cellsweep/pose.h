/// @file
/// A solid box somewhere in space: what an engine makes an axis-aligned box from by itself.
#pragma once

#include <array>

namespace cellsweep {

/// A box by its centre, its half extents along its own axes, and a rotation: the points c + R·e with
/// |e[k]| <= half_extents[k]. Lengths in the caller's unit. 40 bytes, no padding.
struct BodyPose {
  std::array<float, 3> centre{};
  std::array<float, 3> half_extents{};           ///< 0 or more
  std::array<float, 4> orientation{0, 0, 0, 1};  ///< quaternion x, y, z, w, of length 1/1024 to 1024

  friend bool operator==(const BodyPose&, const BodyPose&) = default;
};

static_assert(sizeof(BodyPose) == 40);

/// Centre and extents of a pose together reach no further than this from the origin on any axis.
inline constexpr float kLargestPoseReach = 0x1p100F;

}  // namespace cellsweep
