/// @file
/// The cells of a node around a box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "engines/stream/cells/cell_tree.h"
#include "queries/nearest/layers.h"

namespace cellsweep::queries {

/// The cells of a node by how many layers they are away from those that the box is in.
class CellRings {
 public:
  CellRings(const stream::Node& node, const Aabb& box, const double (&gaps)[3])
      : box_(box), gaps_{gaps[0], gaps[1], gaps[2]}, range_(node.grid.range_of(box)) {
    const stream::GridNumbers grid = node.grid.numbers();
    for (unsigned axis = 0; axis < 3; ++axis) layers_[axis] = Layers(grid, axis);
    steps_[1] = grid.row;
    steps_[2] = grid.plane;
  }

  /// On to the next ring; false when there is none.
  bool go_on() {
    ++ring_;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (range_.low[axis] >= ring_ || layers_[axis].top() - range_.high[axis] >= ring_) return true;
    }
    return false;
  }

  /// None of the ring's cells, nor of those behind it, is nearer.
  double distance() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (range_.low[axis] >= ring_) nearest = std::min(nearest, gap(axis, range_.low[axis] - ring_));
      if (layers_[axis].top() - range_.high[axis] >= ring_)
        nearest = std::min(nearest, gap(axis, range_.high[axis] + ring_));
    }
    return nearest;
  }

  /// Calls `visit(cell, gaps)` for each cell of the ring.
  template <class Visit>
  void for_each_cell(const Visit& visit) const {
    double gaps[3];
    for (std::uint32_t z = first(2); z <= last(2); ++z) {
      gaps[2] = gap(2, z);
      for (std::uint32_t y = first(1); y <= last(1); ++y) {
        gaps[1] = gap(1, y);
        const bool is_all = offset(2, z) == ring_ || offset(1, y) == ring_;
        for (std::uint32_t x = first(0); x <= last(0); ++x) {
          if (!is_all && offset(0, x) != ring_) {
            x = std::max(x, range_.high[0] + ring_ - 1);  // on to the other side
            continue;
          }
          gaps[0] = gap(0, x);
          visit(x + y * steps_[1] + z * steps_[2], gaps);
        }
      }
    }
  }

 private:
  std::uint32_t first(unsigned axis) const { return range_.low[axis] - std::min(range_.low[axis], ring_); }
  std::uint32_t last(unsigned axis) const {
    return range_.high[axis] + std::min(layers_[axis].top() - range_.high[axis], ring_);
  }
  std::uint32_t offset(unsigned axis, std::uint32_t layer) const {
    if (layer < range_.low[axis]) return range_.low[axis] - layer;
    return layer > range_.high[axis] ? layer - range_.high[axis] : 0;
  }
  double gap(unsigned axis, std::uint32_t layer) const {
    if (layer >= range_.low[axis] && layer <= range_.high[axis]) return gaps_[axis];
    const double gap = layer < range_.low[axis] ? box_.min[axis] - layers_[axis].high(layer)
                                                : layers_[axis].low(layer) - box_.max[axis];
    return std::max(gap, gaps_[axis]);
  }

  const Aabb& box_;
  double gaps_[3];
  stream::CellRange range_;
  Layers layers_[3];
  std::uint32_t steps_[3] = {1, 0, 0};
  std::uint32_t ring_ = 0;
};

/// A cell of a ring.
struct NearCell {
  double square;  // of the distance that it has at least
  std::uint32_t index;
  double gaps[3];
};

/// Cells of a ring, the nearest first.
struct NearCells {
  static constexpr unsigned kMost = 27;

  void add(const NearCell& cell) {
    unsigned place = count++;
    for (; place > 0 && cells[place - 1].square > cell.square; --place) cells[place] = cells[place - 1];
    cells[place] = cell;
  }

  NearCell cells[kMost];  // NOLINT(*-member-init): as far as it is read
  unsigned count = 0;
};

}  // namespace cellsweep::queries
