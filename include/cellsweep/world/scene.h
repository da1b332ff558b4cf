/// @file
/// Scenes made from a seed: worlds full of bodies that tests, benchmarks and the experiment share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/world.h"

namespace cellsweep {

/// Where among the bodies, in the order of their ids, a giant stands: one that is larger than the world. With
/// `none` scene `pile` still has its plane, in the first place.
enum class GiantSlot { none, first, middle, last };

/// What a scene is made of. The same settings give the same bits on every machine.
struct SceneSettings {
  std::string scene = "paper";  ///< a name of scene_table()
  std::size_t bodies = 1024;
  std::uint64_t seed = 1;
  std::optional<double> moving{};  ///< share of the bodies that move, 0 to 1; none: the scene's own
  double speed = 1.0;              ///< factor on how far bodies move a frame; 0 to 1,000,000
  bool spinning = false;  ///< moving bodies also turn (W2), at most 0.1 radians a frame whatever the speed
  GiantSlot giant = GiantSlot::none;  ///< takes the place of a body, and never moves
  bool rest_is_static = false;        ///< bodies that never move are; with a script, that is the giant alone
  unsigned groups = 0;                ///< bodies belong to so many groups in turn, 32 at most, and meet only
                                      ///< those of other groups; 0 or 1: all meet all
};

/// One row of the scene table.
struct SceneInfo {
  std::string_view name;
  std::string_view summary;  ///< one sentence for a person
  /// Share of the bodies that move unless SceneSettings name another; none where that is not theirs to name.
  std::optional<double> moving = 0.1;
  /// Whether it is a World, whose bodies fly, at most 0.1 of their shortest edge a frame unless the summary
  /// says otherwise, and may spin. The bodies of the others follow a script.
  bool is_world = true;
};

/// All scenes.
CELLSWEEP_API std::span<const SceneInfo> scene_table();

/// The row of the scene table of this name, or null.
CELLSWEEP_API const SceneInfo* find_scene(std::string_view name);

/// The share of bodies that move with these settings: theirs, or the scene's own; 0 for a scene that has
/// none.
CELLSWEEP_API double moving_share(const SceneSettings& settings);

/// The world of a scene at frame 0. Errors: bad_option for a name that is not in the table, a moving share
/// outside 0 to 1, a speed outside 0 to 1,000,000, more bodies than 32-bit ids name, what the scene does not
/// have (SceneInfo), or a scene that is no World.
CELLSWEEP_API Result<World> make_scene(const SceneSettings& settings);

/// The filters that the settings give to the bodies of their world, by id: those whose velocities are 0 never
/// move. None when the settings ask for none.
CELLSWEEP_API std::vector<BodyFilter> scene_filters(const SceneSettings& settings, const World& world);

/// The room that a scene's bodies are in, but for its giant and for the way of one frame. Errors: those of
/// make_scene_frames().
CELLSWEEP_API Result<Aabb> scene_bounds(const SceneSettings& settings);

/// The frames of a scene; they never end. Errors: those of make_scene(), but for scenes that are no World.
CELLSWEEP_API Result<std::unique_ptr<FrameSource>> make_scene_frames(const SceneSettings& settings);

}  // namespace cellsweep
