/// @file
/// Walks through a tree of boxes along a path.
#pragma once

#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"
#include "queries/kernels/tree_walk.h"

namespace cellsweep::queries {
namespace {

/// A path against the boxes of nodes. What rounding may do is in the numbers beforehand: fewer steps from the
/// node to its answer.
template <class Lanes>
class CastAtNode {
 public:
  using Vector = VectorOf<Lanes>;

  explicit CastAtNode(const CastNumbers& path)
      : end_(all<Lanes>(path.end)), certain_end_(all<Lanes>(path.certain_end)) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned goes_down = path.goes_down >> axis & 1;
      near_[axis] = axis + 3 * goes_down;
      far_[axis] = axis + 3 - 3 * goes_down;
      enters_from_[axis] = all<Lanes>(path.front[axis]);
      leaves_from_[axis] = all<Lanes>(path.back[axis]);
      enters_by_[axis] = all<Lanes>(path.inverse[axis] * kSmaller);
      leaves_by_[axis] = all<Lanes>(path.inverse[axis] * kLarger);
      if (path.is_flat && path.inverse[axis] == 0) stand_still(path, axis);
    }
  }

  void end(float time) { end_ = all<Lanes>(time); }

  /// A bit for each box of the node that the path may touch, and when it does at the earliest. What is said
  /// of places where there is no box means nothing.
  std::uint32_t test(const TreeNode& node, float (&enter)[TreeNode::kBoxes]) const {
    return test_each([&](unsigned place) {
      Vector enters;
      const Vector leaves = times(node, place, enters_by_, leaves_by_, end_, enters);
      __builtin_memcpy(enter + place, &enters, sizeof(enters));
      return Lanes::bits(Lanes::less_equal(enters, leaves));
    });
  }

  /// Whether the path touches one of these for certain, which test() found. Only where its numbers tell.
  bool is_certain(const TreeNode& node, std::uint32_t bodies) const {
    // Numbers that are too small for a normal one may come out as the same: less, not less or equal.
    const std::uint32_t others = test_each([&](unsigned place) {
      Vector enters;
      const Vector leaves = times(node, place, leaves_by_, enters_by_, certain_end_, enters);
      return Lanes::bits(Lanes::less_equal(leaves, enters));
    });
    return without(bodies, others & bodies) != 0;
  }

 private:
  // On an axis along which the path does not move, boxes that do not reach where it is are behind its end,
  // and those that it has not left it never leaves. Such a side is 0 times infinity from one that it grazes,
  // which is no bound.
  [[gnu::cold]] void stand_still(const CastNumbers& path, unsigned axis) {
    enters_from_[axis] = all<Lanes>(path.high[axis]);
    leaves_from_[axis] = all<Lanes>(path.low[axis]);
    enters_by_[axis] = leaves_by_[axis] = all<Lanes>(__builtin_inff());
  }

  template <class Test>
  static std::uint32_t test_each(const Test& test) {
    std::uint32_t bits = 0;
    for (unsigned first = 0; first < TreeNode::kBoxes; first += Lanes::kCount) bits |= test(first) << first;
    return bits;
  }

  // When the path has come to boxes on all axes, and has left them on one. A product that overflows, or is
  // too small for a normal number, is rounded as others are: what enters no later than it leaves comes out
  // so.
  Vector times(const TreeNode& node, unsigned place, const Vector (&enters_by)[3],
               const Vector (&leaves_by)[3], Vector end, Vector& enters) const {
    Vector enter[3];
    for (unsigned axis = 0; axis < 3; ++axis) {
      enter[axis] = (face(node, near_[axis], place) - enters_from_[axis]) * enters_by[axis];
      end = smaller((face(node, far_[axis], place) - leaves_from_[axis]) * leaves_by[axis], end);
    }
    enters = larger(enter[0], larger(enter[1], larger(enter[2], Vector{})));
    return end;
  }

  static Vector face(const TreeNode& node, unsigned number, unsigned place) {
    return load<Lanes>(node.faces[number] + place);
  }

  unsigned near_[3], far_[3];  // the faces at which the path enters and leaves boxes
  Vector enters_from_[3], leaves_from_[3], enters_by_[3], leaves_by_[3];
  Vector end_, certain_end_;
};

template <class Lanes>
void walk_tree_on_path(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  CastAtNode<Lanes> cast(path);
  WaitingNodes<true> waiting(nodes);
  float keys[TreeNode::kBoxes];
  for (const TreeNode* node = nodes; node != nullptr;) {
    __builtin_prefetch(node->content);
    const std::uint32_t bits = cast.test(*node, keys);
    if (const std::uint32_t bodies = bits & node->bodies; bodies != 0) {
      if (!take.take(take.self, *node, bodies)) return;
      cast.end(path.end);
    }
    node = waiting.next(*node, bits & node->nodes, keys, path.end);
  }
}

template <class Lanes>
bool walk_tree_to_any(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  const CastAtNode<Lanes> cast(path);
  WaitingNodes<false> waiting(nodes);
  float keys[TreeNode::kBoxes];
  for (const TreeNode* node = nodes; node != nullptr;) {
    __builtin_prefetch(node->content);
    const std::uint32_t bits = cast.test(*node, keys);
    if (const std::uint32_t bodies = bits & node->bodies; bodies != 0) {
      if (cast.is_certain(*node, bodies)) return true;
      if (!take.take(take.self, *node, bodies)) return false;
    }
    node = waiting.next(*node, bits & node->nodes, keys, path.end);
  }
  return false;
}

}  // namespace
}  // namespace cellsweep::queries
