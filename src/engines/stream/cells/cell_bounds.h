/// @file
/// Where the cells of a tree lie, for people to look at.
#pragma once

#include <vector>

#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::stream {

/// Appends the bounds of all innermost cells that hold a box. Cells at the border of a grid, which reach to
/// infinity, are cut off at `bounds`.
[[gnu::cold]] void list_cell_bounds(const Node& node, const Aabb& bounds, std::vector<Aabb>& cells);

}  // namespace cellsweep::stream
