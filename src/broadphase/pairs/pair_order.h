/// @file
/// Turns pairs of slots into pairs of ids, in ascending order.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "broadphase/bodies/id_table.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep {

/// Keeps what makes that quick from update to update. Throws std::bad_alloc.
class PairOrder {
 public:
  /// Writes the pairs of `ascending` and of `more`, which differ, to `pairs`.
  void name_pairs(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending, KeyParts more,
                  Array<Pair>& pairs);

  std::size_t bytes() const { return keys_.bytes() + scratch_.bytes(); }

 private:
  void copy_named(const IdTable& table, std::span<const SlotPair> ascending, Array<Pair>& pairs);
  void sort_in_slot_order(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending,
                          KeyParts more, Array<Pair>& pairs);
  void sort_by_ids(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending, KeyParts more,
                   Array<Pair>& pairs);
  template <class Number>
  void list_keys(Crew& crew, std::span<const SlotPair> ascending, KeyParts more, Number&& number);

  Array<std::uint64_t> keys_;
  Array<std::uint64_t> scratch_;
};

}  // namespace cellsweep
