/// @file
/// The flags that make a scene.
#pragma once

#include <CLI/CLI.hpp>

#include "cellsweep/world/scene.h"

namespace cellsweep::app {

/// Adds --scene, --bodies, --moving, --speed, --spinning and --seed to a command.
struct SceneFlags {
  void add_to(CLI::App& command);

  SceneSettings settings;
};

}  // namespace cellsweep::app
