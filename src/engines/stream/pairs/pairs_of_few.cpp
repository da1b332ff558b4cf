#include "engines/stream/pairs/pairs_of_few.h"

#include <utility>

#include "base/pairs/pair_changes.h"
#include "base/sorting/pair_sort.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

void PairsOfFew::begin(const BodyChanges& changes, const std::uint8_t* marks) {
  bodies_ = &changes;
  marks_ = marks;
  keys_before_.clear();
  keys_now_.clear();
}

std::span<const std::uint64_t> PairsOfFew::had(CellTree& cells, Slot slot, const Aabb& fat_box) {
  find_candidates(cells, slot, fat_box);
  list_before(slot);
  return candidates_.view();
}

std::span<const std::uint64_t> PairsOfFew::has(CellTree& cells, Slot slot, const Aabb& fat_box) {
  find_candidates(cells, slot, fat_box);
  list_now(slot);
  return candidates_.view();
}

void PairsOfFew::stayed(CellTree& cells, Slot slot, const Aabb& fat_box) {
  find_candidates(cells, slot, fat_box);
  list_before(slot);
  list_now(slot);
}

void PairsOfFew::find_candidates(CellTree& cells, Slot slot, const Aabb& fat_box) {
  partners_.clear();
  cells.find_partners(fat_box, partners_);
  candidates_.clear();
  candidates_.allow(bodies_->filters);
  KeyBuffer& found = candidates_.buffer();
  make_room(found, partners_.view().size());
  for (const std::uint64_t key : partners_.view()) {
    const auto other = static_cast<Slot>(key);
    if (other != slot) found.keys[found.size++] = pair_key(make_slot_pair(slot, other));
  }
  candidates_.leave_out();
}

// Those that were asked for have listed it.
void PairsOfFew::list_before(Slot slot) {
  const auto box_before = [&](Slot body) -> const Aabb& {
    return marks_[body] != kUnchanged ? bodies_->before[body] : bodies_->boxes[body];
  };
  list(slot, kAsked, box_before, keys_before_);
}

// Those that will be asked for list it.
void PairsOfFew::list_now(Slot slot) {
  list(
      slot, kChanged, [&](Slot body) -> const Aabb& { return bodies_->boxes[body]; }, keys_now_);
}

template <class BoxOf>
void PairsOfFew::list(Slot slot, std::uint8_t left_out, const BoxOf& box_of, Keys& pairs) const {
  const BoxLanes box(box_of(slot));
  const std::span<const std::uint64_t> candidates = candidates_.view();
  KeyBuffer& found = pairs.buffer();
  make_room(found, candidates.size());
  for (const std::uint64_t key : candidates) {
    const auto first = static_cast<Slot>(key >> 32);
    const Slot other = first == slot ? static_cast<Slot>(key) : first;
    if (marks_[other] == left_out || !overlap(box, BoxLanes(box_of(other)))) continue;
    found.keys[found.size++] = key;
  }
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
  for (const Keys* keys : {&partners_, &candidates_, &keys_before_, &keys_now_}) sum += keys->bytes();
  for (const Array<SlotPair>* list : {&before_, &now_, &began_, &ended_}) sum += list->bytes();
  return sum;
}

}  // namespace cellsweep::stream
