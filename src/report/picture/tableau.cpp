#include <algorithm>
#include <iterator>
#include <memory>
#include <span>

#include "cellsweep/broadphase.h"
#include "geometry/bounds.h"
#include "report/hand_over.h"
#include "report/oracle.h"
#include "report/picture/picture.h"

namespace cellsweep::report {
namespace {

BodyPose pose_of(const Aabb& box) {
  BodyPose pose;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.centre[axis] = 0.5F * box.min[axis] + 0.5F * box.max[axis];
    pose.half_extents[axis] = 0.5F * box.max[axis] - 0.5F * box.min[axis];
  }
  return pose;
}

bool is_wall(const Aabb& box, const Aabb& world) {
  constexpr float kMostOfTheWorld = 0.9F;
  int long_axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float edge = box.max[axis] - box.min[axis];
    long_axes += edge >= kMostOfTheWorld * (world.max[axis] - world.min[axis]) ? 1 : 0;
  }
  return long_axes >= 2;
}

std::vector<Pair> pairs_of(const FrameSource& source) {
  Broadphase engine;
  if (!insert_all(engine, source).ok() || !engine.update().ok()) return oracle_pairs(source);
  return {engine.pairs().begin(), engine.pairs().end()};
}

}  // namespace

Tableau tableau_of(const FrameSource& source, const Aabb& world) {
  std::vector<bool> is_colliding(source.boxes().size(), false);
  for (const Pair& pair : pairs_of(source)) {
    is_colliding[pair.a] = true;
    is_colliding[pair.b] = true;
  }
  Tableau tableau{.world = world, .bodies = {}, .colliding = {}};
  for (const BodyId body : shown_bodies(source, world)) {
    tableau.bodies.push_back(shown_pose(source, body));
    tableau.colliding.push_back(is_colliding[body]);
  }
  return tableau;
}

std::vector<BodyId> shown_bodies(const FrameSource& source, const Aabb& world) {
  const std::span<const BodyId> bodies = source.bodies();
  const auto is_shown = [&](BodyId body) { return !is_wall(source.boxes()[body], world); };
  if (std::none_of(bodies.begin(), bodies.end(), is_shown)) return {bodies.begin(), bodies.end()};
  std::vector<BodyId> shown;
  std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(shown), is_shown);
  return shown;
}

BodyPose shown_pose(const FrameSource& source, BodyId body) {
  return source.poses().empty() ? pose_of(source.boxes()[body]) : source.poses()[body];
}

// A file that cannot be read any more tells that with its frames.
Aabb stage_of(const FrameFile& file) {
  const Aabb world = file.world();
  Bounds bounds;
  bool has_walls = false;
  const Status status = file.for_each_box([&](const Aabb& box) {
    if (is_wall(box, world)) {
      has_walls = true;
    } else {
      bounds.include(box);
    }
  });
  return status.ok() && has_walls && !bounds.empty() ? bounds.box() : world;
}

}  // namespace cellsweep::report
