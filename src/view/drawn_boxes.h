/// @file
/// What is to be drawn of a simulation, as the graphics card takes it.
#pragma once

#include <array>
#include <vector>

#include "cellsweep/world/world.h"
#include "view/simulation.h"

namespace cellsweep::view {

/// One box. Thirteen floats, no padding.
struct DrawnBox {
  std::array<float, 3> centre{};
  std::array<float, 3> half_extents{};
  std::array<float, 4> orientation{0, 0, 0, 1};  ///< quaternion x, y, z, w
  Color color{};
};

static_assert(sizeof(DrawnBox) == 52);

/// The bodies, colliding ones green, without walls and floors; then the twelve edges of the world as bars.
std::vector<DrawnBox> drawn_boxes(const Simulation& simulation);

/// A box of which only the edges are drawn. Nine floats, no padding.
struct LineBox {
  std::array<float, 3> min{};
  std::array<float, 3> max{};
  Color color{};
};

static_assert(sizeof(LineBox) == 36);

/// What of engine `stream` is to be seen.
struct StreamParts {
  bool fat_boxes = false;
  bool cells = false;
};

/// The fat boxes and the cells of `stream` as they are now, cut off not far from the world; none of other
/// engines.
std::vector<LineBox> line_boxes(const Simulation& simulation, const StreamParts& parts);

}  // namespace cellsweep::view
