#include "broadphase/bodies/move_check.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include "broadphase/bodies/box_checks.h"
#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep {
namespace {

/// Bodies are looked up, and boxes given again are recognised, so many at a time.
constexpr std::size_t kBlock = 32;

/// Whether bodies of consecutive slots stay where they are.
bool are_at_rest(const HeldBodies& held, Slot first, std::span<const Aabb> boxes) {
  if (std::memcmp(boxes.data(), &held.boxes[first], boxes.size_bytes()) != 0) return false;
  return std::all_of(held.states + first, held.states + first + boxes.size(),
                     [](BodyState state) { return state == kAtRest; });
}

}  // namespace

void MoveCheck::run(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                    Share share, ChangedBody* moved, Unmoved unmoved) {
  good_ = ascends_ = true;
  next_ = 0;
  first_ = last_ = kNoSlot;
  list_ = to_ = moved;
  unmoved_ = unmoved;
  for (std::size_t first = share.first; good_ && first < share.last; first += kBlock) {
    const std::size_t count = std::min(kBlock, share.last - first);
    check_block(held, &ids[first], boxes.subspan(first, count));
  }
}

void MoveCheck::check_block(const HeldBodies& held, const BodyId* ids, std::span<const Aabb> boxes) {
  std::array<Slot, kBlock> slots;
  const std::size_t count = boxes.size();
  const bool run = find_slots(held, ids, count, slots.data());
  if (!good_) return;
  if (run && unmoved_ == Unmoved::left_out && are_at_rest(held, slots[0], boxes)) return;
  if (are_clean(boxes)) {
    // Where one body moves, its neighbours in the call mostly do, too: what they have need not be read then,
    // for a body may be listed that stays.
    if (!same_bits(BoxLanes(boxes[0]), BoxLanes(held.boxes[slots[0]]))) return list_all(slots.data(), boxes);
    for (std::size_t i = 0; i < count; ++i) note(held, slots[i], boxes[i]);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Aabb box = canonical(boxes[i]);
    good_ &= is_valid(box);
    note(held, slots[i], box);
  }
}

// True when they are consecutive.
bool MoveCheck::find_slots(const HeldBodies& held, const BodyId* ids, std::size_t count, Slot* slots) {
  const bool as_expected = is_run(held, ids, count, next_);
  const Slot first = as_expected ? next_ : held.table.find(ids[0]);
  if (as_expected || (first != kNoSlot && is_run(held, ids, count, first))) {
    std::iota(slots, slots + count, first);
    note_run(first, count);
    return true;
  }
  // Bodies that are here and there: what they have is on its way while the others are looked up.
  for (std::size_t i = 0; i < count; ++i) held.table.prefetch(ids[i]);
  for (std::size_t i = 0; i < count; ++i) slots[i] = find(held, ids[i]);
  for (std::size_t i = 0; i < count; ++i) note_run(slots[i], 1);
  return false;
}

void MoveCheck::note_run(Slot first, std::size_t count) {
  ascends_ = ascends_ && (last_ == kNoSlot || first > last_);
  if (first_ == kNoSlot) first_ = first;
  last_ = first + static_cast<Slot>(count) - 1;
  next_ = last_ + 1;
}

void MoveCheck::list_all(const Slot* slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) to_[i] = {boxes[i], slots[i]};
  to_ += boxes.size();
}

// Whether these bodies are those of consecutive slots.
bool MoveCheck::is_run(const HeldBodies& held, const BodyId* ids, std::size_t count, Slot first) const {
  if (first > held.table.slot_count() || held.table.slot_count() - first < count) return false;
  if (std::memcmp(ids, held.table.ids() + first, count * sizeof(BodyId)) != 0) return false;
  return held.table.is_full() || std::none_of(held.states + first, held.states + first + count,
                                              [](BodyState state) { return state == kGone; });
}

Slot MoveCheck::find(const HeldBodies& held, BodyId id) {
  const Slot slot = held.table.find(id);
  if (slot == kNoSlot) {
    good_ = false;
    return slot;
  }
  __builtin_prefetch(&held.states[slot]);
  return slot;
}

// A body that has moved already, to somewhere else, may be told to stay.
void MoveCheck::note(const HeldBodies& held, Slot slot, const Aabb& box) {
  const bool differs = !same_bits(BoxLanes(box), BoxLanes(held.boxes[slot]));
  *to_ = {box, slot};
  to_ += differs || held.states[slot] != kAtRest || unmoved_ == Unmoved::kept ? 1 : 0;
}

}  // namespace cellsweep
