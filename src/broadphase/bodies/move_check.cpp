#include "broadphase/bodies/move_check.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "broadphase/bodies/box_checks.h"

namespace cellsweep {
namespace {

/// Bodies are looked up so many at a time.
constexpr std::size_t kCheckBlock = 32;

bool are_held(const HeldBodies& held, Slot first, std::size_t count) {
  return held.table.is_full() ||
         std::none_of(held.boxes.states() + first, held.boxes.states() + first + count,
                      [](BodyState state) { return state == kGone; });
}

/// Whether these are the bodies' slots.
bool are_right(const HeldBodies& held, std::span<const BodyId> ids, const Slot* slots) {
  const std::size_t count = held.table.slot_count();
  const BodyId* const known = held.table.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (slots[i] >= count || known[slots[i]] != ids[i]) return false;
  }
  return held.table.is_full() || std::none_of(slots, slots + ids.size(),
                                              [&](Slot slot) { return held.boxes.states()[slot] == kGone; });
}

}  // namespace

void MoveCheck::run(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                    Share share, Slot* slots) {
  *this = {};
  next_ = static_cast<Slot>(share.first);
  for (std::size_t first = share.first; good_ && first < share.last; first += kCheckBlock) {
    const std::size_t count = std::min(kCheckBlock, share.last - first);
    check_block(held, ids.subspan(first, count), boxes.subspan(first, count), slots + first);
  }
}

// A box that a body has is clean.
void MoveCheck::check_block(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                            Slot* slots) {
  const bool is_run = find_slots(held, ids, slots);
  if (!good_ || (is_run && held.boxes.are_at_rest(slots[0], boxes))) return;
  nobody_moves_ = false;
  if (are_clean(boxes)) return;
  clean_ = false;
  good_ = are_valid(boxes);
}

// True when they are consecutive.
bool MoveCheck::find_slots(const HeldBodies& held, std::span<const BodyId> ids, Slot* slots) {
  Slot first = next_;
  if (!is_run(held, ids, first)) {
    if (are_right(held, ids, slots)) return note_slots({slots, ids.size()});
    first = held.table.find(ids[0]);
    if (first == kNoSlot || !is_run(held, ids, first)) return look_up(held, ids, slots);
  }
  std::iota(slots, slots + ids.size(), first);
  note_run(first, ids.size());
  return true;
}

// Whether these bodies are those of consecutive slots.
bool MoveCheck::is_run(const HeldBodies& held, std::span<const BodyId> ids, Slot first) const {
  const std::size_t slots = held.table.slot_count();
  if (first > slots || slots - first < ids.size()) return false;
  return std::memcmp(ids.data(), held.table.ids() + first, ids.size_bytes()) == 0 &&
         are_held(held, first, ids.size());
}

void MoveCheck::note_run(Slot first, std::size_t count) {
  ascends_ = ascends_ && (last_ == kNoSlot || first > last_);
  if (first_ == kNoSlot) first_ = first;
  last_ = first + static_cast<Slot>(count) - 1;
  next_ = last_ + 1;
}

bool MoveCheck::note_slots(std::span<const Slot> slots) {
  bool descends = false;
  for (std::size_t i = 1; i < slots.size(); ++i) descends |= slots[i - 1] >= slots[i];
  note_run(slots.front(), 1);
  ascends_ = ascends_ && !descends;
  last_ = slots.back();
  next_ = last_ + 1;
  return false;
}

// Bodies that are here and there: where one is found is on its way while the others are looked up.
bool MoveCheck::look_up(const HeldBodies& held, std::span<const BodyId> ids, Slot* slots) {
  for (const BodyId id : ids) held.table.prefetch(id);
  std::transform(ids.begin(), ids.end(), slots, [&](BodyId id) { return held.table.find(id); });
  good_ = good_ && std::find(slots, slots + ids.size(), kNoSlot) == slots + ids.size();
  return good_ && note_slots({slots, ids.size()});
}

}  // namespace cellsweep
