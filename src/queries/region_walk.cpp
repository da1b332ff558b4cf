#include "queries/region_walk.h"

#include <bit>

#include "engines/stream/cells/cell_tree.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"
#include "queries/tree/tree_price.h"

namespace cellsweep::queries {
namespace {

using stream::Cell;
using stream::Node;

class RegionWalk {
 public:
  RegionWalk(const World& world, const Aabb& box, FunctionRef<bool(std::span<const Slot>)> take)
      : kernels_(world.kernels()),
        overlap_(box.min == box.max ? kernels_.overlap_few : kernels_.overlap),
        box_(box),
        take_(take) {}

  bool walk(const BoxTree& tree) {
    const auto take = [](void* self, const TreeNode& node, std::uint32_t bodies) {
      return static_cast<RegionWalk*>(self)->give_bodies_of(node, bodies);
    };
    kernels_.trees->overlap(tree.nodes(), box_, {take, this});
    return goes_on_;
  }

  bool scan(const World& world) {
    return for_each_row(world.boxes(), [&](const BoxRow& row, Slot first) {
      const std::uint32_t found = overlap_(row, box_, places_.data());
      return give(keep_seen(world, first, places_, found));
    });
  }

  // `outer`: on which axes the box starts in the cell that the node is in.
  bool walk(const Node& node, std::uint32_t outer) {
    bool goes_on = true;
    node.grid.for_each_cell(node.grid.block_of(box_), [&](std::uint32_t index, std::uint32_t inner) {
      if (!goes_on) return;
      const Cell& cell = node.cells[index];
      goes_on = cell.node != nullptr ? walk(*cell.node, outer & inner) : look(cell, outer & inner);
    });
    return goes_on;
  }

 private:
  // A box and the one asked for may share several cells: that which holds the lower corner of what they share
  // tells of it.
  bool look(const Cell& cell, std::uint32_t flags) {
    return for_each_row(cell.boxes, [&](const BoxRow& row, std::uint32_t first) {
      const std::uint32_t found = overlap_(row, box_, places_.data());
      std::uint32_t kept = 0;
      for (std::uint32_t i = 0; i < found; ++i) {
        const std::uint32_t tag = cell.boxes.boxes[first + places_[i]].tag;
        places_[kept] = tag & kSlotMask;
        kept += (tag >> kSlotBits | flags) == stream::kWholeFlags ? 1 : 0;
      }
      return give(kept);
    });
  }

  bool give_bodies_of(const TreeNode& node, std::uint32_t bodies) {
    std::uint32_t count = 0;
    for (; bodies != 0; bodies &= bodies - 1) places_[count++] = node.content[std::countr_zero(bodies)];
    goes_on_ = give(count);
    return goes_on_;
  }

  bool give(std::uint32_t count) { return count == 0 || take_({places_.data(), count}); }

  const QueryKernels& kernels_;
  const decltype(QueryKernels::overlap) overlap_;
  const Aabb& box_;
  FunctionRef<bool(std::span<const Slot>)> take_;
  bool goes_on_ = true;
  Places places_;  // NOLINT(*-member-init): as far as it is read
};

}  // namespace

bool walk_region(const World& world, const Aabb& box, FunctionRef<bool(std::span<const Slot>)> take) {
  RegionWalk walk(world, box, take);
  if (world.root() != nullptr) return walk.walk(*world.root(), stream::kWholeFlags);
  if (const BoxTree* const tree = world.tree()) return walk.walk(*tree);
  const bool goes_on = walk.scan(world);
  pay_for_tree(world, world.boxes().size());
  return goes_on;
}

}  // namespace cellsweep::queries
