/// @file
/// The part that engines with little room have in common: bodies get places below the engine's capacity.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// A slot may be any number below kSlotMask, and is given out again only after an update. An engine whose
/// arrays, keys or local stores hold just as many bodies as it takes derives from this class and works with
/// places instead: 0 ... capacity - 1, of which the one freed last is given out first.
class PlacedEngine : public Engine {
 public:
  Result<FoundPairs> update(const BodyChanges& changes, Statistics& statistics) final {
    take_removed(changes);
    take_moved(changes);
    take_inserted(changes);
    return find_pairs(statistics);
  }

 protected:
  /// Called in this order, each with all there are, while a place still has its slot. No places: not called.
  virtual void apply_remove(std::span<const Slot> places) = 0;
  virtual void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) = 0;
  virtual void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) = 0;

  /// The rest of update().
  virtual Result<FoundPairs> find_pairs(Statistics& statistics) = 0;

  /// Places ever given out: an upper bound of every place in use.
  std::size_t place_count() const { return slots_.size(); }

  /// The slot of the body in a place; of one that was freed, the slot that it had.
  Slot slot(Slot place) const { return slots_[place]; }

  /// The pair of the bodies in two places.
  SlotPair slots(Slot one, Slot other) const { return make_slot_pair(slots_[one], slots_[other]); }

 private:
  void take_removed(const BodyChanges& changes) {
    if (changes.removed.empty()) return;
    scratch_.clear();
    for (const Slot slot : changes.removed) scratch_.push_back(places_[slot]);
    apply_remove(scratch_);
    free_.insert(free_.end(), scratch_.begin(), scratch_.end());
  }

  void take_moved(const BodyChanges& changes) {
    if (changes.moved.empty()) return;
    scratch_.clear();
    boxes_.clear();
    for (const Slot slot : changes.moved) {
      scratch_.push_back(places_[slot]);
      boxes_.push_back(changes.boxes[slot]);
    }
    apply_move(scratch_, boxes_);
  }

  void take_inserted(const BodyChanges& changes) {
    if (changes.inserted.empty()) return;
    scratch_.clear();
    boxes_.clear();
    places_.resize(changes.boxes.size(), kNoSlot);
    for (const Slot slot : changes.inserted) {
      places_[slot] = take_place(slot);
      scratch_.push_back(places_[slot]);
      boxes_.push_back(changes.boxes[slot]);
    }
    apply_insert(scratch_, boxes_);
  }

  Slot take_place(Slot slot) {
    if (free_.empty()) {
      slots_.push_back(slot);
      return static_cast<Slot>(slots_.size() - 1);
    }
    const Slot place = free_.back();
    free_.pop_back();
    slots_[place] = slot;
    return place;
  }

  std::vector<Slot> slots_;    // by place
  std::vector<Slot> places_;   // by slot
  std::vector<Slot> free_;     // places
  std::vector<Slot> scratch_;  // places of the list at hand
  std::vector<Aabb> boxes_;    // and their boxes
};

}  // namespace cellsweep
