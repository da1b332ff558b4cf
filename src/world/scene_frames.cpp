#include <memory>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"

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
class SceneFrames final : public FrameSource {
 public:
  SceneFrames(std::string name, World world) : name_(std::move(name)), world_(std::move(world)) {
    boxes_.reserve(world_.size());
    poses_.reserve(world_.size());
    for (const RigidBody& body : world_.bodies()) {
      boxes_.push_back(body.box);
      poses_.push_back(pose_of(body));
    }
  }

  std::string name() const override { return name_; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyPose> poses() const override { return poses_; }
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
};

}  // namespace

Result<std::unique_ptr<FrameSource>> make_scene_frames(const SceneSettings& settings) {
  Result<World> world = make_scene(settings);
  if (!world) return world.status();
  return std::unique_ptr<FrameSource>(std::make_unique<SceneFrames>(settings.scene, std::move(*world)));
}

}  // namespace cellsweep
