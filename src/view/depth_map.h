/// @file
/// How far light from one direction gets: a depth texture that a world is drawn into.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Geometry>

#include "cellsweep/aabb.h"

namespace cellsweep::view {

/// Belongs to the context that is current when it is made, and goes before it.
class DepthMap {
 public:
  explicit DepthMap(int edge);
  ~DepthMap();
  DepthMap(const DepthMap&) = delete;
  DepthMap& operator=(const DepthMap&) = delete;

  /// From here on is drawn into the map, which is empty.
  void begin() const;

  /// Makes it texture number `unit`, to be compared with.
  void bind(int unit) const;

 private:
  int edge_;
  GLuint texture_ = 0;
  GLuint framebuffer_ = 0;
};

/// World to clip space for light from direction `to_light` (of length 1): the world fills the map.
Eigen::Matrix4f light_matrix(const Aabb& world, const Eigen::Vector3f& to_light);

}  // namespace cellsweep::view
