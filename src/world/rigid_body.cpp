#include <array>
#include <cmath>

#include "cellsweep/world/world.h"

namespace cellsweep {
namespace {

/// The absolute values of a rotation matrix, row by row.
using AbsoluteRotation = std::array<std::array<float, 3>, 3>;

/// Dividing by the squared length makes a quaternion of any length but zero a rotation; the identity gives
/// exact zeros and ones.
AbsoluteRotation absolute_rotation(const Eigen::Quaternionf& q) {
  const float x = q.x();
  const float y = q.y();
  const float z = q.z();
  const float w = q.w();
  const float s = 2.0F / (((x * x + y * y) + z * z) + w * w);
  return {
      {{std::abs(1.0F - s * (y * y + z * z)), std::abs(s * (x * y - z * w)), std::abs(s * (x * z + y * w))},
       {std::abs(s * (x * y + z * w)), std::abs(1.0F - s * (x * x + z * z)), std::abs(s * (y * z - x * w))},
       {std::abs(s * (x * z - y * w)), std::abs(s * (y * z + x * w)), std::abs(1.0F - s * (x * x + y * y))}}};
}

}  // namespace

void RigidBody::update_box() {
  const AbsoluteRotation rotation = absolute_rotation(orientation);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& row = rotation[axis];
    const float reach = (row[0] * half_extents[0] + row[1] * half_extents[1]) + row[2] * half_extents[2];
    box.min[axis] = position[axis] - reach;
    box.max[axis] = position[axis] + reach;
  }
}

}  // namespace cellsweep
