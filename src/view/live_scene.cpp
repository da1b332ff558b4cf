#include "view/live_scene.h"

#include <utility>

namespace cellsweep::view {
namespace {

BodyPose pose_of(const RigidBody& body) {
  const Eigen::Vector3f& c = body.position;
  const Eigen::Vector3f& h = body.half_extents;
  const Eigen::Quaternionf& q = body.orientation;
  return {{c.x(), c.y(), c.z()}, {h.x(), h.y(), h.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

// Place and shape of the one; course of the other, but for a body that had one.
void carry_over(const RigidBody& from, RigidBody& to) {
  to.position = from.position;
  to.half_extents = from.half_extents;
  to.orientation = from.orientation;
  to.box = from.box;
  if (!from.dynamic || !to.dynamic) return;
  to.velocity = from.velocity;
  to.angular_velocity = from.angular_velocity;
}

}  // namespace

Result<std::unique_ptr<LiveScene>> LiveScene::make(const SceneSettings& settings) {
  Result<World> world = make_scene(settings);
  if (!world) return world.status();
  return std::unique_ptr<LiveScene>(new LiveScene(settings, std::move(*world)));
}

LiveScene::LiveScene(SceneSettings settings, World world)
    : settings_(std::move(settings)), world_(std::move(world)) {
  for (const RigidBody& body : world_.bodies()) {
    boxes_.push_back(body.box);
    poses_.push_back(pose_of(body));
  }
  filters_ = scene_filters(settings_, world_);
}

Status LiveScene::set_moving(double share) {
  SceneSettings wanted = settings_;
  wanted.moving = share;
  Result<World> world = make_scene(wanted);
  if (!world) return world.status();
  for (const BodyId id : world->ids()) carry_over(*world_.find(id), *world->find(id));
  world_ = std::move(*world);
  settings_ = wanted;
  filters_ = scene_filters(settings_, world_);
  return {};
}

bool LiveScene::advance() {
  world_.step();
  for (const BodyId id : world_.moved()) {
    boxes_[id] = world_.bodies()[id].box;
    poses_[id] = pose_of(world_.bodies()[id]);
  }
  return true;
}

}  // namespace cellsweep::view
