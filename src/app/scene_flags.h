/// @file
/// The flags that make a scene.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cellsweep/world/scene.h"

namespace cellsweep::app {

/// Adds --scene, --bodies, --moving, --speed, --spinning, --giant and --seed to a command.
struct SceneFlags {
  void add_to(CLI::App& command);

  /// Adds --static and --groups.
  void add_filters_to(CLI::App& command);

  /// Refuses all of them beside an option that names a file in the scene's place. Added last.
  static void exclude_beside(CLI::App& command, CLI::Option& file);

  /// The flags that make this scene.
  std::string text() const;

  SceneSettings settings;
};

}  // namespace cellsweep::app
