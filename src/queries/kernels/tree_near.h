/// @file
/// Walks through a tree of boxes for what is near: of each node the nearest first.
#pragma once

#include <cstddef>
#include <cstdint>

#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"
#include "queries/kernels/tree_walk.h"

namespace cellsweep::queries {
namespace {

/// Squares of the distances of a node's boxes.
using Squares = float[TreeNode::kBoxes];

/// A bit for each that is no more than that.
template <class Lanes>
std::uint32_t no_more(const Squares& squares, VectorOf<Lanes> most) {
  std::uint32_t bits = 0;
  for (unsigned first = 0; first < TreeNode::kBoxes; first += Lanes::kCount)
    bits |= Lanes::bits(Lanes::less_equal(load<Lanes>(squares + first), most)) << first;
  return bits;
}

/// The nodes above the one that is looked at, each with those of its own that wait. While nobody is found all
/// of them do, and hardly any is looked at afterwards: no more is done for them than to keep their bits.
template <class Lanes>
class NodesAbove {
 public:
  explicit NodesAbove(const TreeNode* nodes) : nodes_(nodes) {}

  /// Those of the node that is looked at.
  Squares& squares() { return levels_[count_].squares; }
  /// Of that node these wait.
  void add(const TreeNode& node, std::uint32_t bits) {
    levels_[count_].content = node.content;
    levels_[count_].bits = bits;
    count_ += bits != 0 ? 1 : 0;
  }
  /// The next node that is no further than that; null: there is none.
  const TreeNode* next(VectorOf<Lanes> most) {
    while (count_ > 0) {
      Level& last = levels_[count_ - 1];
      const std::uint32_t bits = last.bits & no_more<Lanes>(last.squares, most);
      const std::uint32_t all_but_one = bits & (bits - 1);
      count_ -= all_but_one == 0 ? 1 : 0;
      if (bits == 0) continue;
      const unsigned lane = all_but_one == 0 ? lowest(bits) : Lanes::least(last.squares, bits);
      last.bits = without(bits, 1U << lane);
      return nodes_ + last.content[lane];
    }
    return nullptr;
  }

 private:
  struct alignas(64) Level {
    Squares squares;
    const std::uint32_t* content;
    std::uint32_t bits;
  };

  static unsigned lowest(std::uint32_t bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

  const TreeNode* nodes_;
  Level levels_[kTreeDepth + 1];  // NOLINT(*-member-init): as far as it is read
  unsigned count_ = 0;
};

/// Writes the keys of those whose bits are set, nearest first but for the last bits of their squares, and any
/// behind them. Each is compared with all, and no branch depends on them.
template <unsigned kLanes>
void put_in_order(const Squares& squares, std::uint32_t bits, std::uint64_t (&keys)[TreeNode::kBoxes]) {
  using Numbers [[gnu::vector_size(4 * kLanes)]] = std::int32_t;
  constexpr std::size_t kVectors = TreeNode::kBoxes / kLanes;
  constexpr std::int32_t kLane = TreeNode::kBoxes - 1;  // no two are the same
  std::int32_t numbers[TreeNode::kBoxes];
  for (unsigned lane = 0; lane < TreeNode::kBoxes; ++lane) {
    const auto square = __builtin_bit_cast(std::int32_t, squares[lane]);
    const auto number = (square & ~kLane) | static_cast<std::int32_t>(lane);
    numbers[lane] = (bits >> lane & 1) != 0 ? number : __INT32_MAX__;
  }
  Numbers places[kVectors] = {};
  for (const std::int32_t number : numbers) {
    const Numbers all_lanes = number - Numbers{};
    for (std::size_t vector = 0; vector < kVectors; ++vector) {
      Numbers those;
      __builtin_memcpy(&those, numbers + vector * kLanes, sizeof(those));
      places[vector] -= all_lanes < those;
    }
  }
  std::int32_t place[TreeNode::kBoxes];
  for (std::size_t vector = 0; vector < kVectors; ++vector)
    __builtin_memcpy(place + vector * kLanes, &places[vector], sizeof(places[vector]));
  for (unsigned lane = 0; lane < TreeNode::kBoxes; ++lane) keys[place[lane]] = near_key(squares[lane], lane);
}

/// Gives bodies of nodes, and keeps to what the question has become thereby.
template <class Lanes>
class NearBodies {
 public:
  NearBodies(const NearNumbers& question, const TakeNearBodies& take)
      : question_(question), take_(take), most_(all<Lanes>(question.most)) {}

  VectorOf<Lanes> most() const { return most_; }

  bool give(const TreeNode& node, const Squares& squares, std::uint32_t bodies) {
    if (!question_.wants_one) return give_all(node, squares, bodies);
    while (bodies != 0) {
      const unsigned lane = Lanes::least(squares, bodies);
      const std::uint64_t key = near_key(squares[lane], lane);
      if (!give(node, &key, 1)) return false;
      bodies = without(bodies, 1U << lane) & no_more<Lanes>(squares, most_);
    }
    return true;
  }

 private:
  bool give_all(const TreeNode& node, const Squares& squares, std::uint32_t bodies) {
    std::uint64_t keys[TreeNode::kBoxes];
    put_in_order<Lanes::kCount>(squares, bodies, keys);
    return give(node, keys, static_cast<std::uint32_t>(__builtin_popcount(bodies)));
  }

  bool give(const TreeNode& node, const std::uint64_t* keys, std::uint32_t count) {
    const bool goes_on = take_.take(take_.self, node, keys, count);
    most_ = all<Lanes>(question_.most);
    return goes_on;
  }

  const NearNumbers& question_;
  const TakeNearBodies& take_;
  VectorOf<Lanes> most_;
};

template <class Lanes>
void walk_tree_for_near(const TreeNode* nodes, const NearNumbers& question, const TakeNearBodies& take) {
  NearLanes<Lanes> lanes(question);
  NodesAbove<Lanes> above(nodes);
  NearBodies<Lanes> near(question, take);
  for (const TreeNode* node = nodes; node != nullptr; node = above.next(lanes.most)) {
    Squares& squares = above.squares();
    const std::uint32_t bits = test_node<Lanes>(
        *node, squares,
        [&](const auto& faces, VectorOf<Lanes>& square) { return lanes.test(faces, square); });
    const std::uint32_t bodies = bits & node->bodies;
    if (bodies != 0) {
      if (!near.give(*node, squares, bodies)) return;
      lanes.most = near.most();
    }
    above.add(*node, without(bits, bodies));
  }
}

template <class Lanes>
void walk_tree_within(const TreeNode* nodes, const NearNumbers& question, const TakeBodiesWithin& take) {
  const NearLanes<Lanes> lanes(question);
  const VectorOf<Lanes> certain = all<Lanes>(question.certain);
  WaitingNodes waiting(nodes);
  Squares squares;
  for (NodeOffset at = 0; at != kNoNode;) {
    const TreeNode& node = waiting.at(at);
    const std::uint32_t bits = test_node<Lanes>(
        node, squares, [&](const auto& faces, VectorOf<Lanes>& square) { return lanes.test(faces, square); });
    const std::uint32_t bodies = bits & node.bodies;
    if (bodies != 0 && !take.take(take.self, node, bodies, bodies & no_more<Lanes>(squares, certain))) return;
    at = waiting.next(node, without(bits, bodies), squares, question.most);
  }
}

}  // namespace
}  // namespace cellsweep::queries
