#include "queries/path_walk.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <new>

#include "engines/stream/cells/cell_tree.h"
#include "queries/layer_way.h"
#include "queries/outward.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"
#include "queries/tree/tree_price.h"

namespace cellsweep::queries {
namespace {

using stream::Cell;
using stream::Node;

/// A path's numbers for kernels, and how their time is counted.
class PathNumbers {
 public:
  explicit PathNumbers(const Cast& cast) {
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest = std::max(largest, std::fabs(cast.axis(axis).direction));
    scale_ = power_of_two_of(largest);
    numbers_.is_flat = false;
    for (std::size_t axis = 0; axis < 3; ++axis) set_axis(cast.axis(axis), cast.end(), axis);
    end(cast.end());
  }

  const CastNumbers& numbers() const { return numbers_; }

  void end(double time) {
    const double scaled = time * scale_;
    numbers_.end = scaled > kFarthest ? std::numeric_limits<float>::infinity() : above(scaled);
  }

 private:
  static constexpr double kFarthest = 1e38;

  // The largest one that is not above a number of that size; of smaller ones than that, about it.
  static double power_of_two_of(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(std::max(number, 0x1p-1000));
    return std::bit_cast<double>(bits >> 52 << 52);
  }

  void set_axis(const Cast::Axis& path, double end, std::size_t axis) {
    constexpr double kMostInverse = 0x1p60;
    constexpr float kFar = std::numeric_limits<float>::infinity();
    const double inverse = path.inverse * scale_;
    numbers_.from_min[axis] = path.high;
    numbers_.from_max[axis] = path.low;
    numbers_.low[axis] = -kFar;
    numbers_.high[axis] = kFar;
    numbers_.wide[axis] = 0;
    if (inverse != 0 && std::fabs(inverse) <= kMostInverse) {
      numbers_.inverse[axis] = static_cast<float>(inverse);
      return;
    }
    const double way = path.direction == 0 ? 0 : path.direction * end;
    numbers_.inverse[axis] = 0;
    numbers_.wide[axis] = kFar;
    numbers_.is_flat = true;
    numbers_.low[axis] = way == 0 ? path.low : below(path.low + std::min(way, 0.0));
    numbers_.high[axis] = way == 0 ? path.high : above(path.high + std::max(way, 0.0));
  }

  double scale_ = 1;     // times in lengths of the scaled direction are so many times as large
  CastNumbers numbers_;  // NOLINT(*-member-init): all set by the constructor
};

class PathWalk {
 public:
  PathWalk(const World& world, const Cast& cast, FunctionRef<double(std::span<const Candidate>)> take)
      : world_(world), kernels_(world.kernels()), numbers_(cast), end_(cast.end()), take_(take) {}

  void walk(const BoxTree& tree) {
    const auto take = [](void* self, const TreeNode& node, std::uint32_t bodies) {
      return static_cast<PathWalk*>(self)->give_bodies_of(node, bodies);
    };
    kernels_.cast_tree(tree.nodes(), numbers_.numbers(), {take, this});
  }

  void scan() {
    looks_ = world_.boxes().size();
    for_each_row(world_.boxes(), [&](const BoxRow& row, Slot first) {
      const std::uint32_t found = kernels_.cast(row, numbers_.numbers(), places_.data());
      std::uint32_t kept = 0;
      for (std::uint32_t i = 0; i < found; ++i) {
        const Slot slot = first + places_[i];
        places_[kept] = slot;
        kept += world_.is_seen(slot) ? 1 : 0;
      }
      return give_slots(kept);
    });
  }

  void walk(const Node& node, const Cast& cast) {
    for (std::size_t axis = 0; axis < 3; ++axis) ways_[axis] = AxisWay(cast.axis(axis), cast.end());
    walk(node, {0, end_});
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
      if (here.from > end_) return;
      if (here.from <= here.to) go_on<kAxis>(cut, cell + layer * cut.steps[kAxis], here);
    }
  }

  template <unsigned kAxis>
  void go_on(const Cut& cut, std::uint32_t cell, const Interval& time) {
    if constexpr (kAxis < 2) {
      cut_axis<kAxis + 1>(cut, cell, time);
    } else {
      if (time.from > end_) return;
      looks_ += kLooksOfCell;
      const Cell& next = cut.cells[cell];
      if (next.node != nullptr) return walk(*next.node, time);
      if (next.boxes.count > 0) look_later(next, time.from);
    }
  }

  // A cell's boxes are on their way to the cache while those of the one before are looked at.
  void look_later(const Cell& cell, double from) {
    const auto* const boxes = reinterpret_cast<const std::byte*>(cell.boxes.boxes);
    for (std::size_t line = 0; line < kPrefetched; line += kCacheLine) __builtin_prefetch(boxes + line);
    look_at_waiting();
    waiting_ = {&cell, from};
  }

  void look_at_waiting() {
    if (waiting_.cell != nullptr && waiting_.from <= end_) look(*waiting_.cell);
  }

  void look(const Cell& cell) {
    looks_ += cell.boxes.count;
    for_each_row(cell.boxes, [&](const BoxRow& row, std::uint32_t first) {
      const std::uint32_t found = kernels_.cast(row, numbers_.numbers(), places_.data());
      for (std::uint32_t i = 0; i < found; ++i)
        places_[i] = cell.boxes.boxes[first + places_[i]].tag & kSlotMask;
      return give_slots(found);
    });
  }

  // Those in places_.
  bool give_slots(std::uint32_t count) {
    for (std::uint32_t first = 0; first < count; first += kGiven) {
      const std::uint32_t given = std::min(count - first, kGiven);
      for (std::uint32_t i = 0; i < given; ++i) {
        const Slot slot = places_[first + i];
        put(i, {slot, world_.box(slot)});
      }
      if (!give(given)) return false;
    }
    return true;
  }

  bool give_bodies_of(const TreeNode& node, std::uint32_t bodies) {
    std::uint32_t count = 0;
    for (; bodies != 0; bodies &= bodies - 1)
      put(count++, candidate_of(node, static_cast<std::size_t>(std::countr_zero(bodies))));
    return give(count);
  }

  void put(std::uint32_t place, const Candidate& candidate) {
    ::new (&candidates_.list[place]) Candidate(candidate);
  }

  bool give(std::uint32_t count) {
    if (count == 0) return true;
    const double end = take_({candidates_.list, count});
    if (end < end_) {
      end_ = end;
      if (end >= 0) numbers_.end(end);
    }
    return end_ >= 0;
  }

  /// One that the path enters no earlier than that.
  struct WaitingCell {
    const Cell* cell = nullptr;
    double from = 0;
  };
  static constexpr std::size_t kPrefetched = 256;
  static constexpr std::size_t kCacheLine = 64;
  static constexpr std::uint64_t kLooksOfCell = 4;
  static constexpr std::uint32_t kGiven = TreeNode::kBoxes;

  /// Room that nobody initialises: a question looks at few of them or none.
  union Candidates {
    Candidates() {}  // NOLINT(modernize-use-equals-default): that would be no constructor
    Candidate list[kGiven];
  };

  const World& world_;
  const QueryKernels& kernels_;
  PathNumbers numbers_;
  double end_;
  FunctionRef<double(std::span<const Candidate>)> take_;
  AxisWay ways_[3];
  WaitingCell waiting_;
  std::uint64_t looks_ = 0;
  Places places_;  // NOLINT(*-member-init): as far as it is read
  Candidates candidates_;
};

}  // namespace

void walk_path(const World& world, const Cast& cast, FunctionRef<double(std::span<const Candidate>)> take) {
  PathWalk walk(world, cast, take);
  if (const BoxTree* const tree = world.tree()) return walk.walk(*tree);
  if (world.root() != nullptr) {
    walk.walk(*world.root(), cast);
  } else {
    walk.scan();
  }
  pay_for_tree(world, walk.looks());
}

}  // namespace cellsweep::queries
