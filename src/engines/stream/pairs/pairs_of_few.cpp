#include "engines/stream/pairs/pairs_of_few.h"

#include <utility>

#include "base/pair_changes.h"
#include "base/pair_sort.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

void PairsOfFew::ask_before(CellTree& cells, const BodyChanges& changes, const std::uint8_t* fresh) {
  const auto box_before = [&](Slot slot) -> const Aabb& {
    return fresh[slot] != 0 ? changes.before[slot] : changes.boxes[slot];
  };
  keys_before_.clear();
  ask(cells, changes, changes.removed, fresh, box_before, keys_before_);
  ask(cells, changes, changes.moved, fresh, box_before, keys_before_);
}

void PairsOfFew::ask_now(CellTree& cells, const BodyChanges& changes, const std::uint8_t* fresh) {
  const auto box_now = [&](Slot slot) -> const Aabb& { return changes.boxes[slot]; };
  keys_now_.clear();
  ask(cells, changes, changes.moved, fresh, box_now, keys_now_);
  ask(cells, changes, changes.inserted, fresh, box_now, keys_now_);
}

// The fat boxes that a box overlaps, and of these the boxes. A pair of two that changed is found from both
// sides, and listed from one.
template <class BoxOf>
void PairsOfFew::ask(CellTree& cells, const BodyChanges& changes, std::span<const Slot> slots,
                     const std::uint8_t* fresh, const BoxOf& box_of, Keys& pairs) {
  pairs.allow(changes.filters);
  for (const Slot slot : slots) {
    const BoxLanes box(box_of(slot));
    partners_.clear();
    cells.find_partners(box_of(slot), partners_);
    KeyBuffer& found = pairs.buffer();
    make_room(found, partners_.view().size());
    for (const std::uint64_t key : partners_.view()) {
      const auto other = static_cast<Slot>(key);
      const bool is_listed = other != slot && (fresh[other] == 0 || slot < other);
      if (!is_listed || !overlap(box, BoxLanes(box_of(other)))) continue;
      found.keys[found.size++] = pair_key(make_slot_pair(slot, other));
    }
    pairs.leave_out();
  }
}

std::span<const std::uint64_t> PairsOfFew::partners(CellTree& cells, std::span<const BodyFilter> filters,
                                                    Slot slot, const Aabb& box) {
  partners_.clear();
  cells.find_partners(box, partners_);
  pairs_.clear();
  pairs_.allow(filters);
  KeyBuffer& found = pairs_.buffer();
  make_room(found, partners_.view().size());
  for (const std::uint64_t key : partners_.view()) {
    const auto other = static_cast<Slot>(key);
    if (other != slot) found.keys[found.size++] = pair_key(make_slot_pair(slot, other));
  }
  pairs_.leave_out();
  return pairs_.view();
}

SlotPairChanges PairsOfFew::changes(Crew& crew) {
  sort(crew, keys_before_, scratch_, before_);
  sort(crew, keys_now_, scratch_, now_);
  find_changes<SlotPair>(before_.view(), now_.view(), {}, began_, ended_);
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

void PairsOfFew::sort(Crew& crew, const Keys& keys, Array<std::uint64_t>& scratch, Array<SlotPair>& pairs) {
  const std::span<const std::uint64_t> all = keys.view();
  sort_pairs(crew, {&all, 1}, scratch, pairs);
}

std::size_t PairsOfFew::bytes() const {
  std::size_t sum = scratch_.bytes();
  for (const Keys* keys : {&partners_, &pairs_, &keys_before_, &keys_now_}) sum += keys->bytes();
  for (const Array<SlotPair>* list : {&before_, &now_, &began_, &ended_}) sum += list->bytes();
  return sum;
}

}  // namespace cellsweep::stream
