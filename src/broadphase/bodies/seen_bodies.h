/// @file
/// The bodies of the last update, by the ids that they had then.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "broadphase/bodies/id_table.h"
#include "broadphase/bodies/staged_boxes.h"

namespace cellsweep {

/// Bodies as the last update saw them, whatever became of their ids since.
class SeenBodies {
 public:
  SeenBodies(const IdTable& table, const StagedBoxes& boxes) : table_(table), boxes_(boxes) {
    gone_.reserve(boxes.removed().size());
    for (const Slot slot : boxes.removed()) gone_.emplace_back(table.id(slot), slot);
    std::sort(gone_.begin(), gone_.end());
  }

  /// The slot that the body of that id had, or kNoSlot.
  Slot find(BodyId id) const {
    const Slot slot = table_.find(id);
    if (slot != kNoSlot && boxes_.state(slot) != kInserted) return slot;
    const auto found = std::lower_bound(gone_.begin(), gone_.end(), std::pair(id, Slot{0}));
    return found != gone_.end() && found->first == id ? found->second : kNoSlot;
  }

 private:
  const IdTable& table_;
  const StagedBoxes& boxes_;
  std::vector<std::pair<BodyId, Slot>> gone_;
};

}  // namespace cellsweep
