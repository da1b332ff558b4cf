/// @file
/// Conversions between Aabb and Eigen's box; the one header of the broadphase that needs Eigen.
#pragma once

#include <Eigen/Geometry>

#include "cellsweep/aabb.h"

namespace cellsweep {

/// The same six numbers as an Eigen box.
inline Eigen::AlignedBox3f to_eigen(const Aabb& box) {
  return {Eigen::Vector3f(box.min[0], box.min[1], box.min[2]),
          Eigen::Vector3f(box.max[0], box.max[1], box.max[2])};
}

/// The same six numbers as an Aabb. Eigen's empty box (min > max) converts too; engines refuse it.
inline Aabb from_eigen(const Eigen::AlignedBox3f& box) {
  return {{box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}};
}

}  // namespace cellsweep
