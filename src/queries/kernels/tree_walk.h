/// @file
/// Walks through a tree of boxes: one question against the boxes of a node at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"

namespace cellsweep::queries {
namespace {

/// Where a node stands behind the topmost one, in bytes. A face of its boxes is read by this and where that
/// face of the topmost one is: a step less than by the node's address, on the way that a walk waits for.
using NodeOffset = std::size_t;
inline constexpr NodeOffset kNoNode = ~NodeOffset{0};

/// Nodes of a tree to be looked at. Of those that one node adds the one with the least key comes first, the
/// others as they lie there: to put them in order takes longer than it saves (EPYC, first on a ray and all,
/// 10,000 and 100,000 bodies: 7 to 16 % of all that a walk takes).
class WaitingNodes {
 public:
  explicit WaitingNodes(const TreeNode* nodes) : nodes_(nodes) {}

  const TreeNode& at(NodeOffset offset) const {
    return *reinterpret_cast<const TreeNode*>(reinterpret_cast<const std::byte*>(nodes_) + offset);
  }

  /// The node to go on with, after one in which those whose bits are set may hold answers: theirs with the
  /// least key, or else the last that waits and whose key is at most that. kNoNode: there is none.
  NodeOffset next(const TreeNode& node, std::uint32_t bits, const float (&keys)[TreeNode::kBoxes],
                  float most) {
    if (bits == 0) return take(most);
    // One alone goes through no memory: the way to the next node is what a walk waits for.
    if ((bits & (bits - 1)) == 0) return offset_of(node.content[lowest(bits)]);
    unsigned nearest = count_;
    std::uint32_t least = ~std::uint32_t{0};
    for (; bits != 0; bits &= bits - 1) {
      const unsigned lane = lowest(bits);
      // Keys are not negative: their bits are in the same order, and compared without a branch.
      const auto key = __builtin_bit_cast(std::uint32_t, keys[lane]);
      waiting_[count_] = {keys[lane], node.content[lane]};
      prefetch(nodes_ + node.content[lane]);
      nearest = key < least ? count_ : nearest;
      least = key < least ? key : least;
      ++count_;
    }
    const std::uint32_t next = waiting_[nearest].node;
    waiting_[nearest] = waiting_[--count_];
    return offset_of(next);
  }

  /// The same where the order is of no use: the first of theirs, or the last that waits. The way to it waits
  /// for no comparison, which is worth more than to come to a body sooner where one is enough.
  NodeOffset next(const TreeNode& node, std::uint32_t bits) {
    if (bits == 0) return count_ > 0 ? offset_of(waiting_[--count_].node) : kNoNode;
    const NodeOffset next = offset_of(node.content[lowest(bits)]);
    for (bits &= bits - 1; bits != 0; bits &= bits - 1) {
      const std::uint32_t other = node.content[lowest(bits)];
      prefetch(nodes_ + other);
      waiting_[count_++].node = other;
    }
    return next;
  }

 private:
  struct Waiting {
    float key;
    std::uint32_t node;
  };

  static NodeOffset offset_of(std::uint32_t number) { return NodeOffset{number} * sizeof(TreeNode); }
  static unsigned lowest(std::uint32_t bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

  NodeOffset take(float most) {
    while (count_ > 0) {
      const Waiting& last = waiting_[--count_];
      if (last.key <= most) return offset_of(last.node);
    }
    return kNoNode;
  }

  static void prefetch(const TreeNode* node) {
    for (unsigned line = 0; line < sizeof(TreeNode); line += 64)
      __builtin_prefetch(reinterpret_cast<const char*>(node) + line);
  }

  const TreeNode* nodes_;
  Waiting waiting_[kWaitingNodes];  // NOLINT(*-member-init): as far as it is read
  unsigned count_ = 0;
};

/// Straight into a register: what is copied into an array of vectors goes through memory, in halves.
template <class Lanes>
VectorOf<Lanes> load(const float* from) {
  VectorOf<Lanes> vector;
  __builtin_memcpy(&vector, from, sizeof(vector));
  return vector;
}

/// The rest of some bits. A difference would go through mask registers where there are any, which takes
/// longer.
inline std::uint32_t without(std::uint32_t bits, std::uint32_t some_of_them) {
  return bits ^ some_of_them;
}

/// Tests the boxes of a node: a bit for each that passes `test(faces, first)`, of those in the places from
/// `first` on.
template <class Lanes, class Test>
std::uint32_t test_node(const TreeNode& node, const Test& test) {
  std::uint32_t bits = 0;
  for (unsigned first = 0; first < TreeNode::kBoxes; first += Lanes::kCount) {
    const auto face = [&](unsigned number) { return load<Lanes>(node.faces[number] + first); };
    const VectorOf<Lanes> faces[6] = {face(0), face(1), face(2), face(3), face(4), face(5)};
    bits |= test(faces, first) << first;
  }
  return bits;
}

/// The same, and their keys: `test(faces, key)`.
template <class Lanes, class Test>
std::uint32_t test_node(const TreeNode& node, float (&keys)[TreeNode::kBoxes], const Test& test) {
  return test_node<Lanes>(node, [&](const auto& faces, unsigned first) {
    VectorOf<Lanes> key;
    const std::uint32_t bits = test(faces, key);
    __builtin_memcpy(keys + first, &key, sizeof(key));
    return bits;
  });
}

template <class Lanes>
void walk_tree_for_overlaps(const TreeNode* nodes, const Aabb& box, const TakeBodies& take) {
  const OverlapLanes<Lanes> lanes(box);
  WaitingNodes waiting(nodes);
  for (NodeOffset at = 0; at != kNoNode;) {
    const TreeNode& node = waiting.at(at);
    const std::uint32_t bits =
        test_node<Lanes>(node, [&](const auto& faces, unsigned) { return lanes.test(faces); });
    const std::uint32_t bodies = bits & node.bodies;
    if (bodies != 0 && !take.take(take.self, node, bodies)) return;
    at = waiting.next(node, without(bits, bodies));
  }
}

}  // namespace
}  // namespace cellsweep::queries
