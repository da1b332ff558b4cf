/// @file
/// What is to be drawn of a simulation, as the graphics card takes it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "cellsweep/world/world.h"
#include "view/probe.h"
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

struct DrawnBoxes {
  std::vector<DrawnBox> all;
  std::size_t first_glowing = 0;  ///< from this one on they are to be seen through what is in front of them

  std::span<const DrawnBox> glowing() const { return std::span(all).subspan(first_glowing); }
};

/// The bodies, without walls and floors, colliding ones green, and as bars the twelve edges of the world.
/// Then, glowing, the bodies that a tool meets, amber, the first one that a ray touches yellow, and the tool
/// as bars: the edges of the box, or the ray where it goes through the world and a little around it.
DrawnBoxes drawn_boxes(const Simulation& simulation, const Probe& probe, const Met& met);

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
