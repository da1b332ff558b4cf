#include "app/scene_flags.h"

#include <string>

#include "app/checks.h"

namespace cellsweep::app {

void SceneFlags::add_to(CLI::App& command) {
  constexpr std::uint64_t kMostBodies = std::uint64_t{1} << 32;
  constexpr double kTopSpeed = 1e6;
  constexpr const char* kGroup = "The scene";
  std::string names;
  for (const SceneInfo& info : scene_table()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  command.add_option("--scene", settings.scene, "Scene: " + names)
      ->type_name("NAME")
      ->group(kGroup)
      ->capture_default_str();
  command.add_option("--bodies", settings.bodies, "Number of bodies")
      ->check(count(0, kMostBodies))
      ->type_name("N")
      ->group(kGroup)
      ->capture_default_str();
  command.add_option("--moving", settings.moving, "Share of the bodies that move, 0 to 1")
      ->check(number(0, 1))
      ->type_name("SHARE")
      ->group(kGroup)
      ->capture_default_str();
  command.add_option("--speed", settings.speed, "Factor on the scene's speeds")
      ->check(number(0, kTopSpeed))
      ->type_name("FACTOR")
      ->group(kGroup)
      ->capture_default_str();
  command.add_flag("--spinning", settings.spinning, "Moving bodies also turn")->group(kGroup);
  command.add_option("--seed", settings.seed, "Seed; the same seed gives the same frames")
      ->check(count())
      ->type_name("N")
      ->group(kGroup)
      ->capture_default_str();
}

}  // namespace cellsweep::app
