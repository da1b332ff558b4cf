#include "queries/nearest/nearest_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "queries/arithmetic.h"
#include "queries/near_numbers.h"
#include "queries/nearest/cell_rings.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"
#include "queries/tree_price.h"

namespace cellsweep::queries {
namespace {

using stream::Cell;
using stream::Grid;
using stream::Node;

/// The way down to a cell: a body that reaches into several cells is looked at in that which has its nearest
/// point.
struct Way {
  const Way* above = nullptr;
  const Grid* grid = nullptr;
  std::uint32_t cell = 0;

  bool leads_to(const Aabb& point) const {
    for (const Way* way = this; way != nullptr; way = way->above) {
      if (way->grid->block_of(point).first != way->cell) return false;
    }
    return true;
  }
};

/// Of the points of a box that are nearest to another one, the first on each axis.
Aabb nearest_point(const Aabb& box, const Aabb& other) {
  Point point;
  for (std::size_t axis = 0; axis < 3; ++axis)
    point[axis] = std::clamp(other.min[axis], box.min[axis], box.max[axis]);
  return box_at(point);
}

/// Makes the first `count` keys the least, in order. Of one alone without a branch for each of the others.
void put_least_first(std::span<std::uint64_t> keys, std::size_t count) {
  if (count != 1) return std::partial_sort(keys.data(), keys.data() + count, keys.data() + keys.size());
  std::uint64_t least = keys[0];
  std::size_t place = 0;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    place = keys[i] < least ? i : place;
    least = std::min(least, keys[i]);
  }
  std::swap(keys[0], keys[place]);
}

class NearestWalk {
 public:
  NearestWalk(const World& world, const Aabb& box, const QueryFilter& filter, NearestList& nearest)
      : world_(world),
        box_(box),
        filter_(filter),
        nearest_(nearest),
        numbers_(near_numbers(box, std::max(nearest.most(), 0.0))) {
    numbers_.wants_one = nearest.room() == 1;
  }

  void walk(const BoxTree& tree) {
    const auto take = [](void* self, const TreeNode& node, const std::uint64_t* keys, std::uint32_t count) {
      static_cast<NearestWalk*>(self)->look_at_bodies(node, {keys, count});
      return true;
    };
    world_.kernels().trees->near(tree.nodes(), numbers_, {take, this});
  }

  void scan() {
    looks_ = world_.boxes().size();
    for_each_row(world_.boxes(), [&](const BoxRow& row, Slot first) {
      look(
          row, [&](std::uint32_t place) { return measured(first + place); },
          [&](Slot slot) { return world_.is_seen(slot); });
      return true;
    });
  }

  /// Boxes, and what is as much work.
  std::uint64_t looks() const { return looks_; }

  // `gaps`: how far what is in the node is on each axis at least.
  void walk(const Node& node, const Way* above, const double (&gaps)[3]) {
    CellRings rings(node, box_, gaps);
    do {
      NearCells cells;
      rings.for_each_cell([&](std::uint32_t index, const double(&here)[3]) {
        looks_ += kLooksOfCell;
        const double square = here[0] * here[0] + here[1] * here[1] + here[2] * here[2];
        if (!is_near(square) || is_empty(node.cells[index])) return;
        if (cells.count == NearCells::kMost) walk(node, above, cells);
        cells.add({square, index, {here[0], here[1], here[2]}});
      });
      walk(node, above, cells);
    } while (rings.go_on() && rings.distance() <= nearest_.most());
  }

 private:
  bool is_near(double square) const {
    const double most = nearest_.most();
    return square * (1 - 0x1p-48) <= most * most;
  }

  static bool is_empty(const Cell& cell) { return cell.node == nullptr && cell.boxes.count == 0; }

  // And leaves none of them.
  void walk(const Node& node, const Way* above, NearCells& cells) {
    for (unsigned i = 0; i < cells.count; ++i) {
      const NearCell& next = cells.cells[i];
      if (!is_near(next.square)) break;
      const Cell& cell = node.cells[next.index];
      const Way way{above, &node.grid, next.index};
      if (cell.node != nullptr) {
        walk(*cell.node, &way, next.gaps);
      } else {
        look_into(cell, way);
      }
    }
    cells.count = 0;
  }

  void look_into(const Cell& cell, const Way& way) {
    looks_ += cell.boxes.count;
    for_each_row(cell.boxes, [&](const BoxRow& row, std::uint32_t first) {
      const stream::TaggedBox* const boxes = cell.boxes.boxes + first;
      look(
          row, [&](std::uint32_t place) { return measured(boxes[place].tag & kSlotMask); },
          [&](Slot slot) { return way.leads_to(nearest_point(world_.box(slot), box_)); });
      return true;
    });
  }

  template <class MeasuredAt, class IsHere>
  void look(const BoxRow& row, const MeasuredAt& measured_at, const IsHere& is_here) {
    const std::uint32_t found = world_.kernels().near(row, numbers_, keys_.data());
    look_at_nearest({keys_.data(), found}, measured_at, is_here);
  }

  /// A body and how far it is.
  struct Measured {
    Slot slot;
    double distance;
  };
  Measured measured(const Aabb& box, Slot slot) const { return {slot, distance_of(box, box_)}; }
  Measured measured(Slot slot) const { return measured(world_.box(slot), slot); }

  // The nearest first. The distances of all bodies of a node are computed side by side where several of them
  // will be asked for.
  void look_at_bodies(const TreeNode& node, std::span<const std::uint64_t> keys) {
    constexpr std::size_t kSeveral = 4;
    const auto is_here = [](Slot) { return true; };
    if (keys.size() < kSeveral || nearest_.room() == 1) {
      const auto one = [&](std::uint32_t place) {
        const Candidate candidate = candidate_of(node, place);
        return measured(candidate.box, candidate.slot);
      };
      look_in_order(keys, one, is_here);
    } else {
      std::array<double, TreeNode::kBoxes> distances;  // NOLINT(*-member-init): the kernel writes all
      world_.kernels().trees->distances(node, box_, distances.data());
      const auto one = [&](std::uint32_t place) { return Measured{node.content[place], distances[place]}; };
      look_in_order(keys, one, is_here);
    }
  }

  // While the list is not full, those that seem to be nearest come first: then most others need not be looked
  // at.
  template <class MeasuredAt, class IsHere>
  void look_at_nearest(std::span<std::uint64_t> keys, const MeasuredAt& measured_at, const IsHere& is_here) {
    put_least_first(keys, std::min(nearest_.room(), keys.size()));
    look_in_order(keys, measured_at, is_here);
  }

  // At those that are still near enough.
  template <class MeasuredAt, class IsHere>
  void look_in_order(std::span<const std::uint64_t> keys, const MeasuredAt& measured_at,
                     const IsHere& is_here) {
    for (const std::uint64_t key : keys) {
      if (std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32)) > numbers_.most) continue;
      offer(measured_at(static_cast<std::uint32_t>(key)), is_here);
    }
  }

  template <class IsHere>
  void offer(const Measured& body, const IsHere& is_here) {
    const auto [slot, distance] = body;
    if (!(distance <= nearest_.most())) return;
    const Neighbor neighbor{world_.id(slot), distance};
    if (!nearest_.takes(neighbor) || !is_here(slot) || !world_.is_answer(filter_, slot)) return;
    nearest_.add(neighbor);
    numbers_.most = square_above(nearest_.most());
  }

  static constexpr std::uint64_t kLooksOfCell = 4;

  const World& world_;
  const Aabb& box_;
  const QueryFilter& filter_;
  NearestList& nearest_;
  std::uint64_t looks_ = 0;
  NearNumbers numbers_;
  Keys keys_;  // NOLINT(*-member-init): as far as it is read
};

}  // namespace

void walk_nearest(const World& world, const Aabb& box, const QueryFilter& filter, NearestList& nearest) {
  if (nearest.most() < 0) return;
  NearestWalk walk(world, box, filter, nearest);
  if (const BoxTree* const tree = world.tree()) return walk.walk(*tree);
  if (world.root() != nullptr) {
    walk.walk(*world.root(), nullptr, {0, 0, 0});
  } else {
    walk.scan();
  }
  pay_for_tree(world, walk.looks());
}

}  // namespace cellsweep::queries
