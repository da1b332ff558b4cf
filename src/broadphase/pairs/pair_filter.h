/// @file
/// Leaves pairs out of what an engine found that the filters of their bodies do not allow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/sorting/pair_sort.h"
#include "broadphase/bodies/slot_filters.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// What throws std::bad_alloc has changed nothing that shows.
class PairFilter {
 public:
  /// The pairs that filters allow. A pair that ended in a slot that a body left for another filter, and began
  /// in the slot that it has now, did neither. Valid until the next call.
  FoundPairs apply(const FoundPairs& found, const SlotFilters& filters);

  std::size_t bytes() const;

 private:
  void allow(std::span<const SlotPair> pairs, const SlotFilters& filters, Array<SlotPair>& allowed);
  void allow_keys(KeyParts parts, const SlotFilters& filters);
  [[gnu::cold]] void cancel(const SlotFilters& filters);
  [[gnu::cold]] void leave_out_cancelled();

  Array<SlotPair> began_;
  Array<SlotPair> ended_;
  List<std::uint64_t> more_began_;
  std::span<const std::uint64_t> more_view_;
  List<std::uint64_t> cancelled_;  // pairs that did neither, by the slots of now
};

}  // namespace cellsweep
