#include "world/scenes/scripted_scene.h"

#include <algorithm>
#include <array>

#include "world/scene_settings.h"

namespace cellsweep {

Aabb SceneScript::giant() const {
  return giant_box(bounds());
}

std::span<const ScriptedScene> scripted_scenes() {
  static const std::array scenes = {stacks_scene(), pile_scene(), ragdolls_scene(), open_world_scene()};
  return scenes;
}

const ScriptedScene* find_scripted(std::string_view name) {
  const auto scenes = scripted_scenes();
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const ScriptedScene& scene) { return scene.info.name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

std::unique_ptr<SceneScript> make_script(const SceneSettings& settings) {
  const ScriptedScene& scene = *find_scripted(settings.scene);
  Random random(settings.seed, scene.stream);
  return scene.make({settings.bodies, moving_share(settings), settings.speed, random.next()});
}

}  // namespace cellsweep
