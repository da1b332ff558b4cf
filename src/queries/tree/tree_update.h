/// @file
/// Brings a tree of boxes up to date: bodies in their places first, then nodes from below.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/memory.h"
#include "queries/tree/box_tree.h"
#include "queries/tree/range.h"

namespace cellsweep::queries {

/// Of a slot whose body is not in the tree.
inline constexpr std::uint32_t kNowhere = ~std::uint32_t{0};

/// Behind all others; without boxes.
std::uint32_t add_node(TreeNodes& nodes);

/// Who was in the tree stays where it is, whatever its new box; others get a free place, where nodes grow the
/// least. A node always stands behind the one above it.
class TreeUpdate {
 public:
  /// `places` by slot.
  TreeUpdate(TreeNodes& nodes, Vector<std::uint32_t>& places, const BodyBoxes& bodies);

  /// The bodies as they are now, of these slots or of all. False: the tree would become too deep.
  bool put(std::span<const Slot> changed);
  bool put_all();

  /// The boxes of nodes. Returns how much further nodes reach than before, but for the topmost.
  double finish();

 private:
  bool put(Slot slot);
  void put_all_of(std::uint32_t number);
  void prefetch_boxes(const TreeNode& node) const;
  bool insert(Slot slot);
  void insert_at(std::uint32_t number, unsigned place, Slot slot, const Range& range);
  void take_out(std::uint32_t number, unsigned place);
  void push_down(std::uint32_t number, unsigned place);
  static unsigned least_growth(const TreeNode& node, const Range& range);
  void touch(std::uint32_t number) { touched_[number / 64] |= std::uint64_t{1} << number % 64; }
  void finish(std::uint32_t number);

  TreeNodes& nodes_;
  Vector<std::uint32_t>& places_;
  BodyBoxes bodies_;
  Vector<std::uint64_t> touched_;  // a bit for each node
  double more_reach_ = 0;
};

}  // namespace cellsweep::queries
