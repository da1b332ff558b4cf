#include "engines/stream/cells/cell_bounds.h"

#include <array>

namespace cellsweep::stream {
namespace {

/// The bounds of one cell of a grid, by its place on each axis.
Aabb bounds_of(const GridNumbers& grid, const std::array<std::uint32_t, 3>& place, const Aabb& outer) {
  Aabb bounds = outer;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto before = static_cast<float>(place[axis]);
    if (before > 0) bounds.min[axis] = grid.origin[axis] + before / grid.scale[axis];
    if (before < grid.top[axis]) bounds.max[axis] = grid.origin[axis] + (before + 1) / grid.scale[axis];
  }
  return bounds;
}

}  // namespace

void list_cell_bounds(const Node& node, const Aabb& bounds, std::vector<Aabb>& cells) {
  const GridNumbers grid = node.grid.numbers();
  for (std::uint32_t i = 0; i < node.grid.cells() && node.cells != nullptr; ++i) {
    const Cell& cell = node.cells[i];
    if (cell.node == nullptr && cell.boxes.count == 0) continue;
    const std::array<std::uint32_t, 3> place = {i % grid.row, i % grid.plane / grid.row, i / grid.plane};
    const Aabb here = bounds_of(grid, place, bounds);
    if (cell.node != nullptr) {
      list_cell_bounds(*cell.node, here, cells);
    } else {
      cells.push_back(here);
    }
  }
}

}  // namespace cellsweep::stream
