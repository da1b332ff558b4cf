/// @file
/// Walks through the bodies that are in a box.
#pragma once

#include <span>

#include "cellsweep/function_ref.h"
#include "queries/regions/region_box.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Calls `take` with slots, at most kRowBoxes at a time, until it returns false; false when it did. Every
/// body whose box overlaps this one is among them, each once, and others are. The box may be infinite.
bool walk_region(const World& world, const RegionBox& box, FunctionRef<bool(std::span<const Slot>)> take);

}  // namespace cellsweep::queries
