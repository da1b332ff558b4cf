/// @file
/// The bodies of the last update, by the ids that they had then.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/sorting/key_sort.h"
#include "broadphase/bodies/id_table.h"
#include "broadphase/bodies/staged_boxes.h"

namespace cellsweep {

/// Bodies as the last update saw them, whatever became of their ids since.
class SeenBodies {
 public:
  SeenBodies(const IdTable& table, const StagedBoxes& boxes) : table_(table), boxes_(boxes) {
    gone_.reserve(boxes.removed().size());
    for (const Slot slot : boxes.removed()) gone_.push_back(key_of(table.id(slot)) | slot);
    sort_keys(gone_);
  }

  /// The slot that the body of that id had, or kNoSlot.
  Slot find(BodyId id) const {
    const Slot slot = table_.find(id);
    if (slot != kNoSlot && boxes_.state(slot) != kInserted) return slot;
    const auto found = std::lower_bound(gone_.begin(), gone_.end(), key_of(id));
    return found != gone_.end() && *found >> 32 == id ? static_cast<Slot>(*found) : kNoSlot;
  }

 private:
  static std::uint64_t key_of(BodyId id) { return std::uint64_t{id} << 32; }

  const IdTable& table_;
  const StagedBoxes& boxes_;
  std::vector<std::uint64_t> gone_;  // ids above slots, ascending
};

}  // namespace cellsweep
