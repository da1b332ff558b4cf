/// @file
/// Boxes of any kind as the ones of a world, for the languages whose callers have others.
#pragma once

#include <span>

#include "base/memory/array.h"
#include "cellsweep/aabb.h"
#include "cellsweep/box_view.h"
#include "cellsweep/status.h"

namespace cellsweep::bindings {

/// The boxes of a view as floats in three dimensions: the caller's own where they lie so already, else in
/// `own`. Doubles are rounded outward, to floats that are no denormals; boxes with a minimum above their
/// maximum stay such. In two dimensions the third axis is 0 to 0. Errors: those of a view in a one-shot call,
/// coordinates without an address above all.
Result<std::span<const Aabb>> boxes_of_world(const BoxView& view, Array<Aabb>& own);

}  // namespace cellsweep::bindings
