/// @file
/// A camera that circles around a world: where it stands, and where things are on its picture.
#pragma once

#include <Eigen/Geometry>

#include "cellsweep/aabb.h"

namespace cellsweep::view {

/// A look from the camera through a point of its picture.
struct Look {
  Eigen::Vector3f eye;
  Eigen::Vector3f direction;  ///< of length 1
  Eigen::Vector3f back;       ///< of length 1, from the middle of the picture to the eye
};

/// At first it sees what `render` draws: down at the world from outside one of its upper corners. Angles in
/// radians, lengths in world units.
class OrbitCamera {
 public:
  explicit OrbitCamera(const Aabb& world);

  /// Turns around the world and over it; never further than straight above or below.
  void orbit(float around, float over);

  /// Farther away by a factor above 1, nearer by one below, within limits.
  void zoom(float factor);

  /// Shifts the world by parts of the picture's height.
  void pan(float right, float up);

  Eigen::Vector3f eye() const { return target_ + back() * distance_; }

  /// World to camera, camera to clip space (OpenGL's: all of −1 to 1). `aspect` is width over height.
  Eigen::Matrix4f view() const;
  Eigen::Matrix4f projection(float aspect) const;

  /// Where a point is on a picture, in pixels from its upper left corner.
  Eigen::Vector2f project(const Eigen::Vector3f& point, float width, float height) const;

  /// Through a point of the picture, in pixels from its upper left corner.
  Look look_through(const Eigen::Vector2f& pixel, float width, float height) const;

 private:
  Eigen::Vector3f back() const;
  Eigen::Vector3f right() const;
  Eigen::Vector3f up() const { return back().cross(right()); }

  float radius_;  // of the world
  Eigen::Vector3f target_;
  float distance_;
  float around_;
  float over_;
};

}  // namespace cellsweep::view
