/// @file
/// The filters of bodies by slot, and which slots follow others because a filter changed.
#pragma once

#include <cstddef>
#include <span>

#include "base/memory/array.h"
#include "base/memory/memory.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// A body gets another slot when its filter changes: that of a slot stays what it is for as long as there are
/// pairs of the slot. It takes no memory until a body has another filter than the default.
class SlotFilters {
 public:
  /// A body that moved on to another slot.
  struct Move {
    Slot from = 0;
    Slot to = 0;
  };

  bool in_use() const { return !filters_.empty(); }
  /// By slot; empty while all are the default. Slots behind the end have the default, too.
  std::span<const BodyFilter> view() const { return filters_; }
  BodyFilter of(Slot slot) const { return filter_of(filters_, slot); }

  /// Makes room for so many slots, and so many more moves: what follows takes no memory.
  void reserve(std::size_t slots, std::size_t moves) {
    make_room(filters_, slots);
    make_room(moves_, moves_.size() + moves);
  }

  void set(Slot slot, const BodyFilter& filter) {
    if (slot >= filters_.size()) {
      if (filter == BodyFilter{}) return;
      filters_.resize(std::size_t{slot} + 1);
    }
    filters_[slot] = filter;
  }

  void move(Slot from, Slot to) { moves_.push_back({from, to}); }
  /// Since the last commit(), in the order in which they came; each slot is in it once.
  std::span<const Move> moves() const { return moves_; }
  /// Pairs of the slots that were left have been told.
  void commit() { moves_.clear(); }

  /// Those of slots that are numbered anew: each gets what slot `before[slot]` had.
  [[gnu::cold]] SlotFilters renumbered(std::span<const Slot> before) const {
    SlotFilters filters;
    if (!in_use()) return filters;
    filters.filters_.reserve(before.size());
    for (const Slot slot : before) filters.filters_.push_back(of(slot));
    return filters;
  }

  std::size_t bytes() const {
    return filters_.capacity() * sizeof(BodyFilter) + moves_.capacity() * sizeof(Move);
  }

 private:
  Vector<BodyFilter> filters_;
  Vector<Move> moves_;
};

}  // namespace cellsweep
