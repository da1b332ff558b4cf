/// @file
/// The fat box of a body: where it may be for some updates, if it keeps its course.
#pragma once

#include "cellsweep/aabb.h"

namespace cellsweep::stream {

/// A box that encloses `now` and, the way that led from `old` to it, what comes next in so many updates. A
/// box that moves further than its own length at a time does not grow.
Aabb fat_box_of(const Aabb& old, const Aabb& now, float updates);

}  // namespace cellsweep::stream
