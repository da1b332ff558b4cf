/// @file
/// A box or a ray that somebody holds into the world, and what it meets.
#pragma once

#include <vector>

#include "cellsweep/query.h"
#include "view/orbit_camera.h"

namespace cellsweep::view {

enum class Tool { none, box, ray };

/// What a tool meets, in the order of query.h; what meets a box does so at time 0.
using Met = std::vector<Touch>;

/// The tool, where it is, and where the mouse has it. One thread at a time.
class Probe {
 public:
  /// The box is in the middle of the world, the ray goes through it.
  explicit Probe(const Aabb& world);

  Tool tool() const { return tool_; }
  const Aabb& box() const { return box_; }
  const Ray& ray() const { return ray_; }

  void choose(Tool tool) { tool_ = tool; }
  /// None, box, ray, and none again.
  void choose_next();
  /// Chooses the box, or the ray, and puts it there.
  void hold(const Aabb& box);
  void hold(const Ray& ray);

  /// The mouse takes it: the box where it is seen; else it jumps to the body that is seen there, or as far
  /// away as it was. A ray goes along the look.
  void grab(const Look& look, const Broadphase& world);
  /// The mouse has moved: the box comes along in the plane that faces the camera.
  void drag(const Look& look);

  /// Makes the box larger by a factor above 1, smaller by one below, within limits.
  void resize(float factor);

 private:
  void move_box_to(const Eigen::Vector3f& centre);

  Aabb world_;
  Tool tool_ = Tool::none;
  Aabb box_;
  Ray ray_;
  Eigen::Vector3f held_;    // a point of the plane in which the box is dragged
  Eigen::Vector3f offset_;  // of the box's centre from where the mouse is in it
};

/// What the tool meets of a world as of its last update: nothing without a tool.
Met met_by(const Probe& probe, const Broadphase& world);

}  // namespace cellsweep::view
