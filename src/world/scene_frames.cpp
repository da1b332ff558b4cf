#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"
#include "world/scene_filters.h"
#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"

namespace cellsweep {
namespace {

BodyPose pose_of(const RigidBody& body) {
  BodyPose pose;
  for (int axis = 0; axis < 3; ++axis) {
    pose.centre[axis] = body.position[axis];
    pose.half_extents[axis] = body.half_extents[axis];
  }
  const Eigen::Quaternionf& q = body.orientation;
  pose.orientation = {q.x(), q.y(), q.z(), q.w()};
  return pose;
}

/// A world in which nobody is added or removed, so that ids are places.
class WorldFrames final : public FrameSource {
 public:
  WorldFrames(const SceneSettings& settings, World world) : name_(settings.scene), world_(std::move(world)) {
    boxes_.reserve(world_.size());
    poses_.reserve(world_.size());
    for (const RigidBody& body : world_.bodies()) {
      boxes_.push_back(body.box);
      poses_.push_back(pose_of(body));
    }
    filters_ = scene_filters(settings, world_);
  }

  std::string name() const override { return name_; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> bodies() const override { return world_.ids(); }
  std::span<const BodyPose> poses() const override { return poses_; }
  std::span<const BodyFilter> filters() const override { return filters_; }
  std::span<const BodyId> moved() const override { return world_.moved(); }

  bool advance() override {
    world_.step();
    for (const BodyId id : world_.moved()) {
      boxes_[id] = world_.bodies()[id].box;
      poses_[id] = pose_of(world_.bodies()[id]);
    }
    return true;
  }

 private:
  std::string name_;
  World world_;
  std::vector<Aabb> boxes_;
  std::vector<BodyPose> poses_;
  std::vector<BodyFilter> filters_;
};

/// A script, and the bodies that follow it.
class ScriptedFrames final : public FrameSource {
 public:
  ScriptedFrames(const SceneSettings& settings, const ScriptedScene& scene)
      : name_(settings.scene),
        come_and_go_(scene.bodies_come_and_go),
        script_(make_script(settings)),
        giant_(giant_body(settings.giant == GiantSlot::none ? scene.giant : settings.giant, settings.bodies)),
        bodies_(settings.bodies, giant_, script_->giant()),
        filters_(make_filters(settings, [this](BodyId id) { return giant_ == id; })) {
    script_->enter(bodies_);
    bodies_.end_frame();
    bodies_.begin_frame();
  }

  std::string name() const override { return name_; }
  bool bodies_come_and_go() const override { return come_and_go_; }
  std::span<const Aabb> boxes() const override { return bodies_.boxes(); }
  std::span<const BodyId> bodies() const override { return bodies_.bodies(); }
  std::span<const BodyFilter> filters() const override { return filters_; }
  std::span<const BodyId> moved() const override { return bodies_.moved(); }
  std::span<const BodyId> inserted() const override { return bodies_.inserted(); }
  std::span<const BodyId> removed() const override { return bodies_.removed(); }

  bool advance() override {
    bodies_.begin_frame();
    script_->step(++frame_, bodies_);
    bodies_.end_frame();
    return true;
  }

 private:
  std::string name_;
  bool come_and_go_;
  std::unique_ptr<SceneScript> script_;
  std::optional<BodyId> giant_;
  SceneBodies bodies_;
  std::vector<BodyFilter> filters_;
  std::size_t frame_ = 0;
};

}  // namespace

std::vector<BodyFilter> scene_filters(const SceneSettings& settings, const World& world) {
  return make_filters(settings, [&](BodyId id) {
    const RigidBody& body = *world.find(id);
    return body.velocity.isZero(0) && body.angular_velocity.isZero(0);
  });
}

Result<std::unique_ptr<FrameSource>> make_scene_frames(const SceneSettings& settings) {
  if (Status status = check_scene(settings); !status.ok()) return status;
  if (const ScriptedScene* scene = find_scripted(settings.scene)) {
    return std::unique_ptr<FrameSource>(std::make_unique<ScriptedFrames>(settings, *scene));
  }
  Result<World> world = make_scene(settings);
  if (!world) return world.status();
  return std::unique_ptr<FrameSource>(std::make_unique<WorldFrames>(settings, std::move(*world)));
}

}  // namespace cellsweep
