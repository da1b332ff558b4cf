#include "view/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include "cellsweep/world/eigen.h"

namespace cellsweep::view {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

// As the camera of the ray-traced pictures.
const Vector3f kFirstBack = Vector3f(0.55F, 0.42F, 0.83F).normalized();
constexpr float kTangent = 0.25F;  // of half the vertical angle
constexpr float kFullAspect = 1.3F;
constexpr float kFill = 0.95F;
constexpr float kDrop = 0.11F;

constexpr float kFullTurn = 2 * static_cast<float>(EIGEN_PI);
constexpr float kSteepest = 1.55F;
constexpr float kNearest = 0.3F;  // in radii of the world
constexpr float kFarthest = 40;

float tangent_at(float aspect) {
  return aspect < kFullAspect ? kTangent * kFullAspect / aspect : kTangent;
}

}  // namespace

OrbitCamera::OrbitCamera(const Aabb& world)
    : radius_(std::max(0.5F * to_eigen(world).diagonal().norm(), 1e-6F)),
      target_(to_eigen(world).center() - Vector3f(0, kDrop * radius_, 0)),
      distance_(kFill * radius_ / kTangent),
      around_(std::atan2(kFirstBack.x(), kFirstBack.z())),
      over_(std::asin(kFirstBack.y())) {}

void OrbitCamera::orbit(float around, float over) {
  around_ = std::remainder(around_ + around, kFullTurn);
  over_ = std::clamp(over_ + over, -kSteepest, kSteepest);
}

void OrbitCamera::zoom(float factor) {
  distance_ = std::clamp(distance_ * factor, kNearest * radius_, kFarthest * radius_);
}

void OrbitCamera::pan(float right_part, float up_part) {
  const float height = 2 * kTangent * distance_;
  target_ -= height * (right_part * right() + up_part * up());
}

Vector3f OrbitCamera::back() const {
  return {std::cos(over_) * std::sin(around_), std::sin(over_), std::cos(over_) * std::cos(around_)};
}

Vector3f OrbitCamera::right() const {
  return {std::cos(around_), 0, -std::sin(around_)};
}

Matrix4f OrbitCamera::view() const {
  Matrix4f matrix = Matrix4f::Identity();
  matrix.block<1, 3>(0, 0) = right().transpose();
  matrix.block<1, 3>(1, 0) = up().transpose();
  matrix.block<1, 3>(2, 0) = back().transpose();
  matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * eye();
  return matrix;
}

Matrix4f OrbitCamera::projection(float aspect) const {
  const float near = std::max(distance_ - 3 * radius_, 0.02F * distance_);
  const float far = distance_ + 8 * radius_;
  Matrix4f matrix = Matrix4f::Zero();
  matrix(0, 0) = 1 / (tangent_at(aspect) * aspect);
  matrix(1, 1) = 1 / tangent_at(aspect);
  matrix(2, 2) = -(far + near) / (far - near);
  matrix(2, 3) = -2 * far * near / (far - near);
  matrix(3, 2) = -1;
  return matrix;
}

Eigen::Vector2f OrbitCamera::project(const Vector3f& point, float width, float height) const {
  const Eigen::Vector4f clip = projection(width / height) * view() * point.homogeneous();
  return {0.5F * width * (1 + clip.x() / clip.w()), 0.5F * height * (1 - clip.y() / clip.w())};
}

Look OrbitCamera::look_through(const Eigen::Vector2f& pixel, float width, float height) const {
  const float aspect = width / height;
  const float rightward = tangent_at(aspect) * aspect * (2 * pixel.x() / width - 1);
  const float upward = tangent_at(aspect) * (1 - 2 * pixel.y() / height);
  return {eye(), (rightward * right() + upward * up() - back()).normalized(), back()};
}

}  // namespace cellsweep::view
