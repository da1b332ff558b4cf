/// @file
/// Slots of ids that came in one batch: the ids in ascending order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Made in less time and memory than a table of scattered ids; finding one, by halving, takes longer. Bodies
/// that are named again in the order in which they came need no table.
class ListedIds {
 public:
  bool empty() const { return entries_.size() == 0; }

  /// Lists ids of the slots from 0 on. False, and nothing is listed, when one is there twice. Throws
  /// std::bad_alloc, and nothing is listed.
  bool list(std::span<const BodyId> ids);

  /// The slot of an id, or kNoSlot.
  Slot find(BodyId id) const;

  std::size_t bytes() const { return entries_.bytes(); }

 private:
  Array<std::uint64_t> entries_;  // each an id above its slot
};

}  // namespace cellsweep
