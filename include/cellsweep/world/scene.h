/// @file
/// Scenes made from a seed: worlds full of bodies that tests, benchmarks and the experiment share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "cellsweep/export.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/world.h"

namespace cellsweep {

/// What a scene is made of. The same settings give the same bits on every machine.
struct SceneSettings {
  std::string scene = "paper";  ///< a name of scene_table()
  std::size_t bodies = 1024;
  std::uint64_t seed = 1;
  double moving = 0.1;    ///< share of the bodies that move, 0 to 1
  double speed = 1.0;     ///< at 1 a body moves at most 0.1 of its shortest edge a frame; 0 to 1,000,000
  bool spinning = false;  ///< moving bodies also turn (W2), at most 0.1 radians a frame whatever the speed
};

/// One row of the scene table.
struct SceneInfo {
  std::string_view name;
  std::string_view summary;  ///< one sentence for a person
};

/// All scenes.
CELLSWEEP_API std::span<const SceneInfo> scene_table();

/// The world of a scene at frame 0. Errors: bad_option for a name that is not in the table, a moving share
/// outside 0 to 1, a speed outside 0 to 1,000,000, or more bodies than 32-bit ids name.
CELLSWEEP_API Result<World> make_scene(const SceneSettings& settings);

/// The frames of a scene; it never ends. Errors: those of make_scene().
CELLSWEEP_API Result<std::unique_ptr<FrameSource>> make_scene_frames(const SceneSettings& settings);

}  // namespace cellsweep
