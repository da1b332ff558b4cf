#include "queries/regions/reach_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "queries/arithmetic.h"
#include "queries/near_numbers.h"
#include "queries/regions/region_walk.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"

namespace cellsweep::queries {
namespace {

using Slots = std::span<const Slot>;

/// Those of some bodies that are near enough, whose boxes by slot lie anywhere in memory. Distances are
/// computed side by side, several in little more time than one.
class NearBodies {
 public:
  NearBodies(const World& world, const Reach& reach) : world_(world), reach_(reach) {}

  /// Of these, at most kRowBoxes: slots() and distances().
  void find(Slots slots) {
    world_.kernels().distances(world_.boxes().data(), slots.data(), static_cast<std::uint32_t>(slots.size()),
                               reach_.box(), distances_.data());
    // Half of them are too far, nobody could foretell which: all are written down, and most written over.
    count_ = 0;
    for (std::size_t i = 0; i < slots.size(); ++i) {
      slots_[count_] = slots[i];
      distances_[count_] = distances_[i];
      count_ += distances_[i] <= reach_.distance() ? 1 : 0;
    }
  }
  Slots slots() const { return std::span(slots_).first(count_); }
  const double* distances() const { return distances_.data(); }

 private:
  const World& world_;
  const Reach& reach_;
  std::size_t count_ = 0;
  std::array<Slot, kRowBoxes> slots_;                           // NOLINT(*-member-init): as far as it is read
  std::array<double, kRowBoxes + kDistancesAtOnce> distances_;  // NOLINT(*-member-init): as far as it is read
};

/// Calls `take(near)` for those of some bodies that are near enough. A walk through cells finds few at a
/// time: they wait for others.
template <class Take>
class WaitingBodies {
 public:
  WaitingBodies(const World& world, const Reach& reach, const Take& take)
      : near_(world, reach), take_(take) {}

  /// At most kRowBoxes.
  void add(Slots slots) {
    if (count_ + slots.size() > kRowBoxes) finish();
    std::ranges::copy(slots, waiting_.begin() + static_cast<std::ptrdiff_t>(count_));
    count_ += slots.size();
  }

  void finish() {
    near_.find(std::span(waiting_).first(count_));
    count_ = 0;
    take_(near_);
  }

 private:
  NearBodies near_;
  const Take& take_;
  std::size_t count_ = 0;
  std::array<Slot, kRowBoxes> waiting_;  // NOLINT(*-member-init): as far as it is read
};

template <class Take>
void for_each_in_cells(const World& world, const Reach& reach, const Take& take) {
  WaitingBodies waiting(world, reach, take);
  walk_region(world, reach.around(), [&](Slots slots) {
    waiting.add(slots);
    return true;
  });
  waiting.finish();
}

/// Bodies of a node of the tree.
using NodeSlots = std::array<Slot, TreeNode::kBoxes>;
using NodeDistances = std::array<double, TreeNode::kBoxes>;

/// Calls `look(node, bodies, certain)` as kernels do, until it returns false.
template <class Look>
void walk_tree(const World& world, const BoxTree& tree, const Reach& reach, Look look) {
  const auto take = [](void* self, const TreeNode& node, std::uint32_t bodies, std::uint32_t certain) {
    return (*static_cast<Look*>(self))(node, bodies, certain);
  };
  world.kernels().trees->within(tree.nodes(), near_numbers(reach.box(), reach.distance()), {take, &look});
}

/// Calls `take` with those in the tree. Hardly one is so close to the distance that it must be measured.
template <class Take>
void for_each_in_tree(const World& world, const BoxTree& tree, const Reach& reach, const Take& take) {
  walk_tree(world, tree, reach, [&](const TreeNode& node, std::uint32_t bodies, std::uint32_t certain) {
    NodeSlots slots;  // NOLINT(*-member-init): as far as it is read
    std::size_t count = 0;
    for (; bodies != 0; bodies &= bodies - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(bodies));
      slots[count] = node.content[place];
      const bool is_near = (certain >> place & 1) != 0 ||
                           distance_of(candidate_of(node, place).box, reach.box()) <= reach.distance();
      count += is_near ? 1 : 0;
    }
    return count == 0 || take(Slots(slots).first(count));
  });
}

/// The same with their distances.
template <class Take>
void measure_in_tree(const World& world, const BoxTree& tree, const Reach& reach, const Take& take) {
  walk_tree(world, tree, reach, [&](const TreeNode& node, std::uint32_t bodies, std::uint32_t) {
    NodeSlots slots;          // NOLINT(*-member-init): as far as it is read
    NodeDistances distances;  // NOLINT(*-member-init): the kernel writes all
    world.kernels().trees->distances(node, reach.box(), distances.data());
    std::size_t count = 0;
    for (; bodies != 0; bodies &= bodies - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(bodies));
      slots[count] = node.content[place];
      distances[count] = distances[place];
      count += distances[count] <= reach.distance() ? 1 : 0;
    }
    take(Slots(slots).first(count), distances.data());
    return true;
  });
}

}  // namespace

void visit_near(const World& world, const Reach& reach, FunctionRef<bool(Slots)> take) {
  if (const BoxTree* const tree = world.tree()) return for_each_in_tree(world, *tree, reach, take);
  NearBodies near(world, reach);
  walk_region(world, reach.around(), [&](Slots slots) {
    near.find(slots);
    return take(near.slots());
  });
}

void list_near(const World& world, const Reach& reach, FunctionRef<void(Slots)> take) {
  if (const BoxTree* const tree = world.tree()) {
    return for_each_in_tree(world, *tree, reach, [&](Slots slots) {
      take(slots);
      return true;
    });
  }
  for_each_in_cells(world, reach, [&](const NearBodies& near) { take(near.slots()); });
}

void measure_near(const World& world, const Reach& reach, FunctionRef<void(Slots, const double*)> take) {
  if (const BoxTree* const tree = world.tree()) return measure_in_tree(world, *tree, reach, take);
  for_each_in_cells(world, reach, [&](const NearBodies& near) { take(near.slots(), near.distances()); });
}

}  // namespace cellsweep::queries
