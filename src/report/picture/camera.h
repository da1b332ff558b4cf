/// @file
/// Where a picture is taken from.
#pragma once

#include <Eigen/Geometry>

#include "cellsweep/aabb.h"
#include "cellsweep/world/eigen.h"
#include "report/picture/solids.h"

namespace cellsweep::report {

/// Looks down at a world from outside one of its upper corners, so near that the world fills the picture.
class Camera {
 public:
  Camera(const Aabb& world, unsigned width, unsigned height) : width_(width), height_(height) {
    const Eigen::AlignedBox3f bounds = to_eigen(world);
    const float radius = 0.5F * bounds.diagonal().norm();
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    tangent_ = aspect < kFullAspect ? kTangent * kFullAspect / aspect : kTangent;
    const Eigen::Vector3f back = Eigen::Vector3f(0.55F, 0.42F, 0.83F).normalized();
    eye_ = bounds.center() + back * (kFill * radius / kTangent) - Eigen::Vector3f(0, kDrop * radius, 0);
    right_ = Eigen::Vector3f::UnitY().cross(back).normalized();
    up_ = back.cross(right_);
    forward_ = -back;
  }

  /// Through the point (x, y) of the picture, in pixels from its upper left corner.
  Ray ray_through(float x, float y) const {
    const float half_height = 0.5F * static_cast<float>(height_);
    const float across = (x - 0.5F * static_cast<float>(width_)) / half_height * tangent_;
    const float upwards = (half_height - y) / half_height * tangent_;
    return {eye_, (forward_ + across * right_ + upwards * up_).normalized()};
  }

 private:
  static constexpr float kTangent = 0.25F;  // of half the vertical angle
  static constexpr float kFullAspect = 1.3F;
  static constexpr float kFill = 0.95F;
  static constexpr float kDrop = 0.11F;

  unsigned width_;
  unsigned height_;
  float tangent_ = 0;
  Eigen::Vector3f eye_;
  Eigen::Vector3f right_;
  Eigen::Vector3f up_;
  Eigen::Vector3f forward_;
};

}  // namespace cellsweep::report
