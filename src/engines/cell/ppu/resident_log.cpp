#include "engines/cell/ppu/resident_log.h"

#include <algorithm>

namespace cellsweep::cell {

void ResidentLog::make_room(Slot slot) {
  if (slot < boxes_.size()) return;
  boxes_.resize(slot + 1);
  state_.resize(slot + 1, State::empty);
}

void ResidentLog::insert(Slot slot, const Aabb& box) {
  make_room(slot);
  boxes_[slot] = box;
  state_[slot] = State::inserted;
  inserted_.push_back(slot);
}

// Calls that repeat themselves between two updates would make the list grow without end.
void ResidentLog::move(Slot slot, const Aabb& box) {
  if (boxes_[slot] == box) return;
  boxes_[slot] = box;
  if (state_[slot] == State::inserted) return;
  if (moved_.size() >= 4 * boxes_.size()) {
    std::sort(moved_.begin(), moved_.end());
    moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
  }
  moved_.push_back(slot);
}

void ResidentLog::remove(Slot slot) {
  if (state_[slot] == State::inserted) {
    std::erase(inserted_, slot);
  } else {
    std::erase(moved_, slot);
    removed_.push_back(slot);
  }
  state_[slot] = State::empty;
}

void ResidentLog::clear() {
  for (const Slot slot : inserted_) state_[slot] = State::known;
  removed_.clear();
  moved_.clear();
  inserted_.clear();
}

}  // namespace cellsweep::cell
