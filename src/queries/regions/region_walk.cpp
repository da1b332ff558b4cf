#include "queries/regions/region_walk.h"

#include <algorithm>
#include <bit>

#include "engines/stream/cells/cell_tree.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"
#include "queries/tree_price.h"

namespace cellsweep::queries {
namespace {

using stream::Cell;
using stream::Node;

class RegionWalk {
 public:
  RegionWalk(const World& world, const RegionBox& box, FunctionRef<bool(std::span<const Slot>)> take)
      : kernels_(world.kernels()), box_(box), take_(take) {}

  bool walk(const BoxTree& tree) {
    const auto take = [](void* self, const TreeNode& node, std::uint32_t bodies) {
      return static_cast<RegionWalk*>(self)->give_bodies_of(node, bodies);
    };
    kernels_.trees->overlap(tree.nodes(), box_.box(), {take, this});
    return goes_on_;
  }

  bool scan(const World& world) {
    return for_each_row(world.boxes(), [&](const BoxRow& row, Slot first) {
      const std::uint32_t found = kernels_.overlap(row, box_.box(), places_.data());
      return give(keep_seen(world, first, places_, found));
    });
  }

  bool walk(const Node& root) {
    walk(root, stream::kWholeFlags);
    if (goes_on_) look_at_waiting();
    return goes_on_;
  }

 private:
  // `outer`: on which axes the box starts in the cell that the node is in.
  void walk(const Node& node, std::uint32_t outer) {
    const stream::CellBlock block = node.grid.block_of(box_.first_four(), box_.last_four());
    node.grid.for_each_cell(block, [&](std::uint32_t index, std::uint32_t inner) {
      if (!goes_on_) return;
      const Cell& cell = node.cells[index];
      if (cell.node != nullptr) return walk(*cell.node, outer & inner);
      if (cell.boxes.count > 0) look_later(cell, outer & inner);
    });
  }

  // A cell's boxes are on their way to the cache while those of the one before are looked at.
  void look_later(const Cell& cell, std::uint32_t flags) {
    prefetch(cell.boxes, kPrefetched);
    look_at_waiting();
    waiting_ = {&cell, flags};
  }

  void look_at_waiting() {
    if (waiting_.cell != nullptr) goes_on_ = look(*waiting_.cell, waiting_.flags);
  }

  // A box and the one asked for may share several cells: that which holds the lower corner of what they share
  // tells of it.
  bool look(const Cell& cell, std::uint32_t flags) {
    for (std::uint32_t first = 0; first < cell.boxes.count; first += kRowBoxes) {
      const std::uint32_t count = std::min(cell.boxes.count - first, kRowBoxes);
      const stream::TaggedBox* const boxes = cell.boxes.boxes + first;
      if (!give(kernels_.overlap_in_cell(boxes, count, box_.box(), flags, places_.data()))) return false;
    }
    return true;
  }

  bool give_bodies_of(const TreeNode& node, std::uint32_t bodies) {
    std::uint32_t count = 0;
    for (; bodies != 0; bodies &= bodies - 1) places_[count++] = node.content[std::countr_zero(bodies)];
    goes_on_ = give(count);
    return goes_on_;
  }

  bool give(std::uint32_t count) { return count == 0 || take_({places_.data(), count}); }

  /// One whose boxes are looked at next, and on which axes the box starts in it.
  struct WaitingCell {
    const Cell* cell = nullptr;
    std::uint32_t flags = 0;
  };
  static constexpr std::size_t kPrefetched = 512;

  const QueryKernels& kernels_;
  const RegionBox& box_;
  FunctionRef<bool(std::span<const Slot>)> take_;
  WaitingCell waiting_;
  bool goes_on_ = true;
  Places places_;  // NOLINT(*-member-init): as far as it is read
};

}  // namespace

bool walk_region(const World& world, const RegionBox& box, FunctionRef<bool(std::span<const Slot>)> take) {
  RegionWalk walk(world, box, take);
  if (world.root() != nullptr) return walk.walk(*world.root());
  if (const BoxTree* const tree = world.tree()) return walk.walk(*tree);
  const bool goes_on = walk.scan(world);
  pay_for_tree(world, world.boxes().size());
  return goes_on;
}

}  // namespace cellsweep::queries
