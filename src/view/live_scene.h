/// @file
/// A scene whose share of moving bodies can be changed while it runs.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::view {

/// The frames of make_scene_frames(), as long as nothing is changed; it never ends. One thread at a time.
class LiveScene final : public FrameSource {
 public:
  /// Errors: those of make_scene().
  static Result<std::unique_ptr<LiveScene>> make(const SceneSettings& settings);

  const Aabb& bounds() const { return world_.bounds(); }
  double moving() const { return moving_share(settings_); }

  /// From the next frame on this share of the bodies moves; all stay where they are, and who moved and still
  /// moves keeps its course. Who is static changes with it, where the settings ask for that. Errors, without
  /// a change: those of make_scene().
  Status set_moving(double share);

  std::string name() const override { return settings_.scene; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> bodies() const override { return world_.ids(); }
  std::span<const BodyPose> poses() const override { return poses_; }
  std::span<const BodyFilter> filters() const override { return filters_; }
  std::span<const BodyId> moved() const override { return world_.moved(); }
  bool advance() override;

 private:
  LiveScene(SceneSettings settings, World world);

  SceneSettings settings_;
  World world_;
  std::vector<Aabb> boxes_;
  std::vector<BodyPose> poses_;
  std::vector<BodyFilter> filters_;
};

}  // namespace cellsweep::view
