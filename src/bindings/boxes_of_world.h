/// @file
/// Boxes of any kind as the ones of a world, for the languages whose callers have others.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/box_view.h"

namespace cellsweep::bindings {

/// The boxes of a view as floats in three dimensions: the caller's own where they lie so already, else in
/// `own`. Doubles are rounded outward, to floats that are no denormals; boxes with a minimum above their
/// maximum stay such. In two dimensions the third axis is 0 to 0. All coordinates have an address. It uses
/// nothing of the library that a shared one does not show.
std::span<const Aabb> boxes_of_world(const BoxView& view, std::vector<Aabb>& own);

}  // namespace cellsweep::bindings
