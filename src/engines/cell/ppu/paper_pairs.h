/// @file
/// The pair manager of cell-paper on the host side (C15): the control's map, and what each body overlapped
/// earlier.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engines/cell/ppu/overlap_matrix.h"
#include "engines/control/pair_manager.h"

namespace cellsweep::cell {

/// Status of every possible pair on each axis. Whatever the SPUs tell is looked up in the map: that is the
/// costly design of the document, kept (C15). What is ours is the order: a frame's keys are gathered and
/// brought to the map in ascending order, each pair once.
class PaperPairs {
 public:
  using Changed = std::vector<control::PairInfo>;

  /// The IDs of bodies that enter must not be in yet.
  void add_body(std::uint32_t id);

  /// Takes all pairs of a body out; those that collided are appended to `ended`, as they were.
  void remove_body(std::uint32_t id, Changed& ended);

  /// C11: the earlier overlaps of changed IDs on an axis become false.
  void clear_earlier(std::size_t axis, std::span<const std::uint32_t> ids);

  /// The pairs with these keys overlap on an axis, or do not.
  void apply(std::size_t axis, std::span<const std::uint32_t> keys, bool overlapping);

  /// Brings all of that to the map. Pairs that begin or stop colliding are appended, as they are now.
  void commit(Changed& changed);

  std::size_t size() const { return pairs_.size(); }

  /// Memory held.
  std::size_t bytes() const;

 private:
  control::PairManager pairs_;
  std::vector<std::uint32_t> entered_;     // IDs, in the order they came
  std::array<OverlapMatrix, 3> overlaps_;  // by ID, on each axis: what the document calls previous collisions
  OverlapMatrix touched_;                  // by ID: pairs that commit() has to look up
};

}  // namespace cellsweep::cell
