#include "queries/paths/path_in_cells.h"

#include <algorithm>
#include <cstddef>

#include "engines/stream/cells/cell_tree.h"
#include "queries/paths/layer_way.h"
#include "queries/rows.h"

namespace cellsweep::queries {
namespace {

using stream::Cell;
using stream::Node;

class CellPath {
 public:
  CellPath(const World& world, PathTaker& taker) : world_(world), kernels_(world.kernels()), taker_(taker) {}

  void scan() {
    looks_ = world_.boxes().size();
    for_each_row(world_.boxes(), [&](const BoxRow& row, Slot first) {
      const std::uint32_t found = kernels_.cast(row, taker_.numbers(), places_.data());
      return give_slots(keep_seen(world_, first, places_, found));
    });
  }

  void walk(const Node& node, const Cast& cast) {
    for (std::size_t axis = 0; axis < 3; ++axis) ways_[axis] = AxisWay(cast.axis(axis), cast.end());
    walk(node, {0, taker_.end()});
    look_at_waiting();
  }

  /// Boxes, and what is as much work.
  std::uint64_t looks() const { return looks_; }

 private:
  /// A node and the order in which its axes are cut: that along which the path crosses most cells first.
  struct Cut {
    const Cell* cells;
    LayerWay ways[3];
    std::uint32_t steps[3];
  };

  void walk(const Node& node, const Interval& time) {
    const stream::GridNumbers grid = node.grid.numbers();
    Cut cut{node.cells, {}, {1, grid.row, grid.plane}};
    for (unsigned axis = 0; axis < 3; ++axis) cut.ways[axis] = LayerWay(ways_[axis], grid, axis);
    const auto order = [&](unsigned one, unsigned other) {
      if (cut.ways[one].layers() >= cut.ways[other].layers()) return;
      std::swap(cut.ways[one], cut.ways[other]);
      std::swap(cut.steps[one], cut.steps[other]);
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    cut_axis<0>(cut, 0, time);
  }

  // Goes on where the path is during some time, within the layers that were chosen on the axes before.
  template <unsigned kAxis>
  void cut_axis(const Cut& cut, std::uint32_t cell, const Interval& time) {
    const LayerWay& way = cut.ways[kAxis];
    if (way.top() == 0) return go_on<kAxis>(cut, cell, time);
    const std::uint32_t low = way.lowest(time);
    const std::uint32_t high = way.highest(time);
    if (low == high || way.stays()) {
      for (std::uint32_t layer = low; layer <= high; ++layer)
        go_on<kAxis>(cut, cell + layer * cut.steps[kAxis], time);
      return;
    }
    for (std::uint32_t i = 0; i <= high - low; ++i) {
      const std::uint32_t layer = way.goes_up() ? low + i : high - i;
      const Interval here{std::max(way.enters(layer), time.from), std::min(way.leaves(layer), time.to)};
      if (here.from > taker_.end()) return;
      if (here.from <= here.to) go_on<kAxis>(cut, cell + layer * cut.steps[kAxis], here);
    }
  }

  template <unsigned kAxis>
  void go_on(const Cut& cut, std::uint32_t cell, const Interval& time) {
    if constexpr (kAxis < 2) {
      cut_axis<kAxis + 1>(cut, cell, time);
    } else {
      if (time.from > taker_.end()) return;
      looks_ += kLooksOfCell;
      const Cell& next = cut.cells[cell];
      if (next.node != nullptr) return walk(*next.node, time);
      if (next.boxes.count > 0) look_later(next, time.from);
    }
  }

  // A cell's boxes are on their way to the cache while those of the one before are looked at.
  void look_later(const Cell& cell, double from) {
    prefetch(cell.boxes, kPrefetched);
    look_at_waiting();
    waiting_ = {&cell, from};
  }

  void look_at_waiting() {
    if (waiting_.cell != nullptr && waiting_.from <= taker_.end()) look(*waiting_.cell);
  }

  void look(const Cell& cell) {
    looks_ += cell.boxes.count;
    for_each_row(cell.boxes, [&](const BoxRow& row, std::uint32_t first) {
      const std::uint32_t found = kernels_.cast(row, taker_.numbers(), places_.data());
      for (std::uint32_t i = 0; i < found; ++i)
        places_[i] = cell.boxes.boxes[first + places_[i]].tag & kSlotMask;
      return give_slots(found);
    });
  }

  // Those in places_.
  bool give_slots(std::uint32_t count) {
    for (std::uint32_t first = 0; first < count; first += PathTaker::kGiven) {
      const std::uint32_t given = std::min(count - first, PathTaker::kGiven);
      for (std::uint32_t i = 0; i < given; ++i) {
        const Slot slot = places_[first + i];
        taker_.put(i, {slot, world_.box(slot)});
      }
      if (!taker_.give(given)) return false;
    }
    return true;
  }

  /// One that the path enters no earlier than that.
  struct WaitingCell {
    const Cell* cell = nullptr;
    double from = 0;
  };
  static constexpr std::size_t kPrefetched = 256;
  static constexpr std::uint64_t kLooksOfCell = 4;

  const World& world_;
  const QueryKernels& kernels_;
  PathTaker& taker_;
  AxisWay ways_[3];
  WaitingCell waiting_;
  std::uint64_t looks_ = 0;
  Places places_;  // NOLINT(*-member-init): as far as it is read
};

}  // namespace

std::uint64_t walk_cells(const World& world, const Cast& cast, PathTaker& taker) {
  CellPath path(world, taker);
  path.walk(*world.root(), cast);
  return path.looks();
}

std::uint64_t scan_boxes(const World& world, PathTaker& taker) {
  CellPath path(world, taker);
  path.scan();
  return path.looks();
}

}  // namespace cellsweep::queries
