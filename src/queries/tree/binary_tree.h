/// @file
/// The tree of boxes before its nodes are filled: cut in two again and again.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/memory/memory.h"
#include "queries/tree/range.h"

namespace cellsweep::queries {

/// Some of the entries, cut in two unless they fit into one node of the tree of boxes.
///
/// That tree is the one of least cost that these cuts allow, where a node costs the weight of what is in it:
/// with so many of a node's places, what is the least that some entries cost, and how are the places shared
/// among the two sides? The sides tell (Ylitie, Karras and Laine 2017, "Efficient incoherent ray traversal on
/// GPUs through compressed wide BVHs").
struct BinaryNode {
  static constexpr std::size_t kPlaces = TreeNode::kBoxes;

  Range range;
  std::uint32_t first = 0;  ///< of its entries
  std::uint32_t count = 0;
  std::uint32_t sides = 0;              ///< where its two sides stand; 0: it has none
  std::uint8_t first_of_all = 0;        ///< how many of all places of a node of its own the first side gets
  std::array<double, kPlaces> costs{};  ///< with one place more than the index
  /// How many of them the first side gets; 0: they become a node of their own.
  std::array<std::uint8_t, kPlaces> first_gets{};

  bool fits() const { return sides == 0; }
};

class BinaryTree {
 public:
  /// Puts the entries into another order.
  explicit BinaryTree(std::span<TreeEntry> entries);

  /// The first one has all entries.
  const BinaryNode& operator[](std::uint32_t number) const { return nodes_[number]; }

 private:
  /// From here on entries are halved by number: no boxes make the tree any deeper.
  static constexpr unsigned kCutBySurface = 40;
  static constexpr unsigned kHalvings = kSlotBits - 4;  // until 2^kSlotBits are 2^4, which fit
  static_assert(kCutBySurface + kHalvings <= kTreeDepth);

  void add(std::uint32_t first, std::size_t count);
  void cut(std::span<TreeEntry> all, std::uint32_t number, unsigned depth);
  void share_places(BinaryNode& node) const;

  Vector<BinaryNode> nodes_;
};

}  // namespace cellsweep::queries
