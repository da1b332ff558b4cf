/// @file
/// A node of the tree of boxes, as the kernels of queries read it.
#pragma once

#include <cstdint>

namespace cellsweep::queries {

/// Boxes side by side, each of a body or of another node. Sixteen, also where a vector holds fewer: what a
/// walk takes is for the branches after each node, which nobody could foretell, and for reaching it in
/// memory. EPYC, 10,000 and 100,000 cubes: rays 4 to 8 % less than with eight. A face of all its boxes is a
/// line of the cache.
struct alignas(64) TreeNode {
  static constexpr unsigned kBoxes = 16;
  static constexpr unsigned kFaceBytes = kBoxes * sizeof(float);

  float faces[6][kBoxes];         ///< minima by axis, then maxima; NaN where there is no box
  std::uint32_t content[kBoxes];  ///< a body's slot, or a node's place in the tree
  std::uint32_t bodies;           ///< a bit for each box that is a body's
  std::uint32_t nodes;            ///< and for each that is another node's
  std::uint32_t above;            ///< where its own box is: place_in_tree() of the node above it
};

inline constexpr std::uint32_t place_in_tree(std::uint32_t node, unsigned place) {
  return node * TreeNode::kBoxes + place;
}

/// No walk through a tree has more nodes before it at a time: each of the at most kTreeDepth nodes above one
/// leaves all but one of its own.
inline constexpr unsigned kTreeDepth = 65;
inline constexpr unsigned kWaitingNodes = kTreeDepth * (TreeNode::kBoxes - 1) + 1;

}  // namespace cellsweep::queries
