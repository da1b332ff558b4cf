/// @file
/// Scenes that are no worlds of rigid bodies: their bodies follow a script.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "cellsweep/world/scene.h"
#include "world/random.h"
#include "world/scenes/scene_bodies.h"

namespace cellsweep {

/// What the bodies of a scene do. Only + − × ÷ √ on floats in a fixed order reach a box, and what is drawn
/// from Random.
class SceneScript {
 public:
  virtual ~SceneScript() = default;

  /// The room that the bodies are in, but for a giant and the way of one frame.
  virtual Aabb bounds() const = 0;

  /// The box of the body that takes the giant's place.
  virtual Aabb giant() const;

  /// Frame 0: inserts the bodies.
  virtual void enter(SceneBodies& bodies) = 0;

  /// Frame 1 and those after it, one after the other.
  virtual void step(std::size_t frame, SceneBodies& bodies) = 0;
};

/// What a script is written for.
struct ScriptSettings {
  std::size_t bodies = 0;
  double moving = 0;
  double speed = 1;
  std::uint64_t seed = 0;  ///< differs from scene to scene
};

struct ScriptedScene {
  SceneInfo info;
  std::uint64_t stream = 0;  ///< as SceneRecipe::stream, and none of those
  std::unique_ptr<SceneScript> (*make)(const ScriptSettings& settings) = nullptr;
  bool bodies_come_and_go = false;
  GiantSlot giant = GiantSlot::none;  ///< where the scene has its giant, unless SceneSettings say where
};

/// All of them, in the order of scene_table().
std::span<const ScriptedScene> scripted_scenes();

/// The scripted scene of this name, or null.
const ScriptedScene* find_scripted(std::string_view name);

/// Of settings that were checked, and name a scripted scene.
std::unique_ptr<SceneScript> make_script(const SceneSettings& settings);

ScriptedScene stacks_scene();
ScriptedScene pile_scene();
ScriptedScene ragdolls_scene();
ScriptedScene open_world_scene();

/// For the row of a scene.
template <class Script>
std::unique_ptr<SceneScript> make_script_of(const ScriptSettings& settings) {
  return std::make_unique<Script>(settings);
}

}  // namespace cellsweep
