/// @file
/// Walks through a tree of boxes along a path.
#pragma once

#include <cstddef>
#include <cstdint>

#include "queries/kernels/kernel.h"
#include "queries/kernels/lanes.h"
#include "queries/kernels/tree_walk.h"

namespace cellsweep::queries {
namespace {

/// What a path has on an axis, in all lanes, and where the topmost node has its faces there. Gaps and
/// inverses are negated, which changes no time: a face is subtracted from a number, and so read by the
/// instruction that needs it.
template <class Lanes>
struct AxisAtNode {
  using Vector = VectorOf<Lanes>;

  AxisAtNode(const TreeNode* topmost, const CastNumbers& path, unsigned axis)
      : near(reinterpret_cast<const std::byte*>(topmost) + path.near[axis]),
        far(reinterpret_cast<const std::byte*>(topmost) + path.far[axis]),
        front(all<Lanes>(path.front[axis])),
        back(all<Lanes>(path.back[axis])),
        sooner(all<Lanes>(path.sooner[axis])),
        later(all<Lanes>(path.later[axis])) {}

  Vector before(std::size_t offset) const { return front - face(near + offset); }
  Vector behind(std::size_t offset) const { return back - face(far + offset); }

  static Vector face(const std::byte* from) { return load<Lanes>(reinterpret_cast<const float*>(from)); }

  const std::byte* near;
  const std::byte* far;
  Vector front, back, sooner, later;
};

/// A path against the boxes of nodes. What rounding may do is in the numbers beforehand: fewer steps from the
/// node to its answer.
template <class Lanes>
class CastAtNode {
 public:
  using Vector = VectorOf<Lanes>;

  CastAtNode(const TreeNode* topmost, const CastNumbers& path)
      : x_(topmost, path, 0),
        y_(topmost, path, 1),
        z_(topmost, path, 2),
        end_(all<Lanes>(path.end)),
        certain_end_(all<Lanes>(path.certain_end)) {}

  void end(float time) { end_ = all<Lanes>(time); }

  /// A bit for each box of the node that the path may touch, and when it does at the earliest. What is said
  /// of places where there is no box means nothing.
  std::uint32_t test(NodeOffset node, float (&enter)[TreeNode::kBoxes]) const {
    return test_each(node, [&](std::size_t faces, unsigned place) {
      const Vector enters =
          first(x_.before(faces) * x_.sooner, y_.before(faces) * y_.sooner, z_.before(faces) * z_.sooner);
      const Vector leaves =
          last(x_.behind(faces) * x_.later, y_.behind(faces) * y_.later, z_.behind(faces) * z_.later, end_);
      __builtin_memcpy(enter + place, &enters, sizeof(enters));
      return Lanes::bits(Lanes::less_equal(enters, leaves));
    });
  }

  /// Whether the path touches one of these for certain, which test() found. Only where its numbers tell.
  bool is_certain(NodeOffset node, std::uint32_t bodies) const {
    // Numbers that are too small for a normal one may come out as the same: less, not less or equal.
    const std::uint32_t others = test_each(node, [&](std::size_t faces, unsigned) {
      const Vector enters =
          surely_first(x_.before(faces) * x_.later, y_.before(faces) * y_.later, z_.before(faces) * z_.later);
      const Vector leaves = surely_last(x_.behind(faces) * x_.sooner, y_.behind(faces) * y_.sooner,
                                        z_.behind(faces) * z_.sooner, certain_end_);
      return Lanes::bits(Lanes::less_equal(leaves, enters));
    });
    return without(bodies, others & bodies) != 0;
  }

 private:
  /// `test(faces, place)` of each vector of boxes: how far their faces are behind the first ones of the
  /// topmost node, and the place of the first box.
  template <class Test>
  static std::uint32_t test_each(NodeOffset node, const Test& test) {
    std::uint32_t bits = 0;
    for (unsigned place = 0; place < TreeNode::kBoxes; place += Lanes::kCount) {
      std::size_t faces = node + place * sizeof(float);
      // Else GCC would keep the sums of `place` and of where each face is, in more registers than there are.
      __asm__("" : "+r"(faces));
      bits |= test(faces, place) << place;
    }
    return bits;
  }

  // When the path has come to boxes on all axes, and when it has left them on one or ends. A product that
  // overflows, or is too small for a normal number, is rounded as others are: what enters no later than it
  // leaves comes out so. Axes two by two, of which none waits for another one. NaN, of a side that a path
  // grazes which stays on that axis, counts for nothing, and on the second of two the first one with it: that
  // is no bound, and no box is missed.
  static Vector first(Vector x, Vector y, Vector z) { return larger(larger(x, y), Lanes::not_negative(z)); }
  static Vector last(Vector x, Vector y, Vector z, Vector end) {
    return smaller(smaller(x, y), smaller(z, end));
  }
  // The same where each bound counts.
  static Vector surely_first(Vector x, Vector y, Vector z) {
    return larger(x, larger(y, Lanes::not_negative(z)));
  }
  static Vector surely_last(Vector x, Vector y, Vector z, Vector end) {
    return smaller(z, smaller(y, smaller(x, end)));
  }

  AxisAtNode<Lanes> x_, y_, z_;
  Vector end_, certain_end_;
};

template <class Lanes>
void walk_tree_on_path(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  CastAtNode<Lanes> cast(nodes, path);
  WaitingNodes waiting(nodes);
  float keys[TreeNode::kBoxes];
  for (NodeOffset at = 0; at != kNoNode;) {
    const TreeNode& node = waiting.at(at);
    __builtin_prefetch(node.content);
    const std::uint32_t bits = cast.test(at, keys);
    if (const std::uint32_t bodies = bits & node.bodies; bodies != 0) {
      if (!take.take(take.self, node, bodies)) return;
      cast.end(path.end);
    }
    at = waiting.next(node, bits & node.nodes, keys, path.end);
  }
}

/// Of a path that does not become shorter.
template <class Lanes>
void walk_tree_on_whole_path(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  const CastAtNode<Lanes> cast(nodes, path);
  WaitingNodes waiting(nodes);
  float keys[TreeNode::kBoxes];
  for (NodeOffset at = 0; at != kNoNode;) {
    const TreeNode& node = waiting.at(at);
    __builtin_prefetch(node.content);
    const std::uint32_t bits = cast.test(at, keys);
    const std::uint32_t bodies = bits & node.bodies;
    if (bodies != 0 && !take.take(take.self, node, bodies)) return;
    at = waiting.next(node, bits & node.nodes);
  }
}

template <class Lanes>
bool walk_tree_to_any(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  CastAtNode<Lanes> cast(nodes, path);
  WaitingNodes waiting(nodes);
  float keys[TreeNode::kBoxes];
  for (NodeOffset at = 0; at != kNoNode;) {
    const TreeNode& node = waiting.at(at);
    __builtin_prefetch(node.content);
    const std::uint32_t bits = cast.test(at, keys);
    if (const std::uint32_t bodies = bits & node.bodies; bodies != 0) {
      if (cast.is_certain(at, bodies)) return true;
      if (!take.take(take.self, node, bodies)) return false;
      // Nothing that stays in a register over the call: else it would be in memory all the time.
      cast = CastAtNode<Lanes>(nodes, path);
    }
    at = waiting.next(node, bits & node.nodes);
  }
  return false;
}

}  // namespace
}  // namespace cellsweep::queries
