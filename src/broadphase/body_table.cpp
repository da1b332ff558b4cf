#include "broadphase/body_table.h"

namespace cellsweep {

void BodyTable::reserve_more(std::size_t count) {
  slots_.reserve(slots_.size() + count);
  ids_.reserve(ids_.size() + count);
  free_.reserve(ids_.size() + count);
}

Slot BodyTable::insert(BodyId id) {
  Slot slot = static_cast<Slot>(ids_.size());
  if (free_.empty()) {
    ids_.push_back(id);
  } else {
    slot = free_.back();
    free_.pop_back();
    ids_[slot] = id;
  }
  slots_.emplace(id, slot);
  return slot;
}

Slot BodyTable::remove(BodyId id) {
  const auto found = slots_.find(id);
  const Slot slot = found->second;
  slots_.erase(found);
  free_.push_back(slot);
  return slot;
}

Slot BodyTable::find(BodyId id) const {
  const auto found = slots_.find(id);
  return found == slots_.end() ? kNoSlot : found->second;
}

}  // namespace cellsweep
