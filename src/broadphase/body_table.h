/// @file
/// The bodies of an engine: which ids there are, and the small dense number each one has inside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "cellsweep/pair.h"

namespace cellsweep {

/// A body's place inside an engine: 0 … slot_count() − 1. The slot of a removed body is given out again.
using Slot = std::uint32_t;

inline constexpr Slot kNoSlot = std::numeric_limits<Slot>::max();

/// Maps ids, any 32-bit numbers, to slots and back.
class BodyTable {
 public:
  std::size_t size() const { return slots_.size(); }

  /// Slots ever given out: an upper bound of every slot in use.
  std::size_t slot_count() const { return ids_.size(); }

  /// Makes room for `count` more bodies at once, so that inserting them does not rehash or copy.
  void reserve_more(std::size_t count);

  /// The slot of a new body; the id must not be in the table. The slot freed last is used first.
  Slot insert(BodyId id);

  /// Frees the slot of a body that is in the table and returns it.
  Slot remove(BodyId id);

  /// The slot of a body, or kNoSlot.
  Slot find(BodyId id) const;

  /// The body in a slot; after its removal the body it held last.
  BodyId id(Slot slot) const { return ids_[slot]; }

 private:
  std::unordered_map<BodyId, Slot> slots_;
  std::vector<BodyId> ids_;
  std::vector<Slot> free_;
};

}  // namespace cellsweep
