/// @file
/// The oracle for worlds too large for all boxes against all boxes: by the cells of one even grid. Simple,
/// and shares no code with any engine.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"

namespace cellsweep::bench {

/// Every overlapping pair of bodies 0 … n − 1, in any order. Boxes are canonical and valid. Time and memory
/// are linear in the bodies while most of them are about as large, and as far apart, as each other. The four
/// largest are compared with all; another giant is entered into every cell it reaches into. Throws
/// std::bad_alloc.
std::vector<Pair> grid_pairs(std::span<const Aabb> boxes);

}  // namespace cellsweep::bench
