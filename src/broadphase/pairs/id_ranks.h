/// @file
/// The order of ids that lie anywhere: small numbers to sort by in their place.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "broadphase/bodies/id_table.h"

namespace cellsweep {

/// The rank of a slot is the number of slots whose ids are smaller. Ranks are found when they are first asked
/// for after bodies came or went.
class IdRanks {
 public:
  /// True when no work is needed to have them.
  bool are_fresh(const IdTable& table) const { return version_ == table.version() && !ranks_.view().empty(); }

  /// Makes them right. Throws std::bad_alloc.
  void refresh(const IdTable& table);

  std::uint32_t rank(Slot slot) const { return ranks_.data()[slot]; }
  BodyId id(std::uint32_t rank) const { return ids_.data()[rank]; }

  std::size_t bytes() const { return ranks_.bytes() + ids_.bytes(); }

 private:
  Array<std::uint32_t> ranks_;  // by slot
  Array<BodyId> ids_;           // by rank
  std::uint64_t version_ = 0;   // of the table
};

}  // namespace cellsweep
