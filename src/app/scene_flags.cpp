#include "app/scene_flags.h"

#include <string>

namespace cellsweep::app {

void SceneFlags::add_to(CLI::App& command) {
  std::string names;
  for (const SceneInfo& info : scene_table()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  command.add_option("--scene", settings.scene, "Scene: " + names)->type_name("NAME")->capture_default_str();
  command.add_option("--bodies", settings.bodies, "Number of bodies")->capture_default_str();
  command.add_option("--moving", settings.moving, "Share of the bodies that move, 0 to 1")
      ->capture_default_str();
  command.add_option("--speed", settings.speed, "Factor on the scene's speeds")->capture_default_str();
  command.add_flag("--spinning", settings.spinning, "Moving bodies also turn");
  command.add_option("--seed", settings.seed, "Seed; the same seed gives the same frames")
      ->capture_default_str();
}

}  // namespace cellsweep::app
