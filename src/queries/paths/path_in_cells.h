/// @file
/// Walks along a path where there is no tree of boxes.
#pragma once

#include <cstdint>

#include "queries/paths/path_taker.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Gives the bodies in the cells that the path goes through, some several times, those of the first ones
/// before others; or all, by slot. Returns what was looked at: boxes, and what is as much work.
std::uint64_t walk_cells(const World& world, const Cast& cast, PathTaker& taker);
std::uint64_t scan_boxes(const World& world, PathTaker& taker);

}  // namespace cellsweep::queries
