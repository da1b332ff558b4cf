/// @file
/// The window: a simulation to look at, with a panel to change it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "view/drawn_boxes.h"
#include "view/simulation.h"

namespace cellsweep::view {

struct ViewSettings {
  unsigned width = 1200;              ///< pixels, 640 to 8,192
  unsigned height = 800;              ///< pixels, 240 to 8,192
  std::optional<std::size_t> frames;  ///< end after so many steps; without it, when the person says so
  std::filesystem::path screenshot;   ///< PNG file of the last picture, made without showing the window
  bool panel = true;                  ///< show the panel
  bool help = false;                  ///< show the keys
  StreamParts stream_parts;           ///< show these of engine `stream`
  std::optional<Aabb> box;            ///< hold this box into the world, or
  std::optional<Ray> ray;             ///< this ray
};

/// How a window ended.
struct ViewEnd {
  Status status;
  std::string no_display;  ///< why there was no window to be had: a phrase; empty when there was one
};

/// Shows the simulation until it ends. Errors: bad_option for settings out of range or in a build without
/// windows, bad_input for a file that cannot be written, those of the engine when `frames` are asked for.
/// Only on the main thread.
ViewEnd show(Simulation& simulation, const ViewSettings& settings);

}  // namespace cellsweep::view
