#include "broadphase/bodies/bodies.h"

#include <algorithm>
#include <iterator>

#include "base/memory/array.h"
#include "base/sorting/key_sort.h"
#include "base/text.h"
#include "broadphase/bodies/box_checks.h"
#include "broadphase/bodies/refusals.h"
#include "broadphase/bodies/seen_bodies.h"

namespace cellsweep {

Status Bodies::insert(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                      std::span<const BodyFilter> filters, std::string_view engine,
                      const Capacity& capacity) {
  Status status = insert_all(crew, ids, boxes, filters, engine, capacity);
  if (status.ok() && !ids.empty()) choice_.note_other();
  return status;
}

Status Bodies::insert_all(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                          std::span<const BodyFilter> filters, std::string_view engine,
                          const Capacity& capacity) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (!filters.empty() && ids.size() != filters.size())
    return length_status(ids.size(), filters.size(), "filters");
  if (Status status = check_room(engine, capacity, ids.size()); !status.ok()) {
    if (!are_valid(boxes)) return find_invalid_boxes(ids, boxes);
    if (Status twice = find_listed_twice(ids); !twice.ok()) return twice;
    if (Status held = find_held(table_, ids); !held.ok()) return held;
    return status;
  }
  const std::size_t slots = table_.slot_count() + ids.size();
  boxes_.reserve(slots);
  const bool staged = table_.appends() && boxes_.stage(crew, boxes);
  if (!staged && !are_valid(boxes)) return find_invalid_boxes(ids, boxes);
  if (!filters.empty() || filters_.in_use()) filters_.reserve(slots, 0);
  const std::size_t before = inserted_.size();
  if (!table_.insert(crew, ids, inserted_)) {
    if (Status status = find_listed_twice(ids); !status.ok()) return status;
    return find_held(table_, ids);
  }
  const std::span<const Slot> inserted = std::span(inserted_).subspan(before);
  if (staged) {
    boxes_.insert_staged(boxes.size());
  } else {
    boxes_.insert(inserted, boxes);
  }
  if (filters.empty() && !filters_.in_use()) return {};
  for (std::size_t i = 0; i < inserted.size(); ++i)
    filters_.set(inserted[i], filters.empty() ? BodyFilter{} : filters[i]);
  return {};
}

Status Bodies::set_filters(std::span<const BodyId> ids, std::span<const BodyFilter> filters) {
  if (ids.size() != filters.size()) return length_status(ids.size(), filters.size(), "filters");
  if (Status status = find_unknown(table_, ids); !status.ok()) return status;
  const std::size_t slots = table_.slot_count() + ids.size();
  table_.reserve_slots(slots);
  table_.reserve_removals(ids.size());
  boxes_.reserve(slots);
  boxes_.reserve_removals(ids.size());
  filters_.reserve(slots, ids.size());
  inserted_.reserve(inserted_.size() + ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) set_filter(table_.find(ids[i]), filters[i]);
  return {};
}

// A slot's filter is what it was as long as there are pairs of the slot, so the body gets another one.
void Bodies::set_filter(Slot slot, const BodyFilter& filter) {
  if (filters_.of(slot) == filter) return;
  if (boxes_.state(slot) == kInserted) return filters_.set(slot, filter);
  const Aabb box = boxes_.next_box(slot);
  const Slot next = table_.renew_slot(slot);
  choice_.note_other();
  boxes_.remove(slot);
  boxes_.insert({&next, 1}, {&box, 1});
  inserted_.push(next);
  filters_.set(next, filter);
  filters_.move(slot, next);
}

// Slots that wait for the next update are nobody's.
Status Bodies::check_room(std::string_view engine, const Capacity& capacity, std::size_t more) const {
  const std::uint64_t slots = std::uint64_t{table_.slot_count()} + more;
  const std::uint64_t bodies = std::uint64_t{size()} + more;
  return check_capacity(engine, capacity, slots > kSlotMask ? std::max(slots, capacity.bodies + 1) : bodies);
}

Status Bodies::add(Crew& crew, std::span<const Aabb> boxes, std::span<BodyId> ids, std::string_view engine,
                   const Capacity& capacity) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (!are_valid(boxes)) return find_invalid_boxes({}, boxes);
  if (Status status = check_room(engine, capacity, ids.size()); !status.ok()) return status;
  slots_.reserve(ids.size());
  slots_.set_size(ids.size());
  choice_.choose(table_, slots_);
  if (Status status = insert_all(crew, slots_, boxes, {}, engine, capacity); !status.ok()) return status;
  std::copy(slots_.begin(), slots_.end(), ids.begin());
  return {};
}

Status Bodies::move(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (ids.empty()) return {};
  if (!check_moves(crew, ids, boxes)) {
    if (Status status = find_invalid_boxes(ids, boxes); !status.ok()) return status;
    return find_unknown(table_, ids);
  }
  const auto stays = [](const MoveCheck& check) { return check.nobody_moves(); };
  if (!std::all_of(checks_.begin(), checks_.begin() + crew.active(), stays))
    boxes_.move(crew, checked_moves(crew, boxes));
  return {};
}

bool Bodies::check_moves(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  checks_.resize(crew.workers());
  if (moved_.size() < ids.size()) moved_.resize(ids.size(), 0);
  const HeldBodies held{table_, boxes_};
  crew.run([&](unsigned worker) {
    const Share share = Share::of(ids.size(), worker, crew.active());
    checks_[worker].run(held, ids, boxes, share, moved_.data());
  });
  return std::ranges::all_of(std::span(checks_).first(crew.active()), &MoveCheck::good);
}

MovedBodies Bodies::checked_moves(const Crew& crew, std::span<const Aabb> boxes) const {
  MovedBodies bodies{std::span(moved_).first(boxes.size()), boxes, true, true};
  for (unsigned worker = 0; worker < crew.active(); ++worker) {
    const MoveCheck& check = checks_[worker];
    bodies.clean = bodies.clean && check.clean();
    bodies.ascends =
        bodies.ascends && check.ascends() && (worker == 0 || checks_[worker - 1].last() < check.first());
  }
  return bodies;
}

Status Bodies::remove(std::span<const BodyId> ids) {
  if (!ascends(ids)) {
    if (Status status = find_listed_twice(ids); !status.ok()) return status;
  }
  if (Status status = find_unknown(table_, ids); !status.ok()) return status;
  boxes_.reserve_removals(ids.size());
  table_.reserve_removals(ids.size());
  for (const BodyId id : ids) {
    const Slot slot = table_.find(id);
    table_.remove(slot);
    some_unseen_ = some_unseen_ || boxes_.state(slot) == kInserted;
    boxes_.remove(slot);
  }
  return {};
}

Status Bodies::boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  const SeenBodies seen(table_, boxes_);
  const auto is_unseen = [&](BodyId id) { return seen.find(id) == kNoSlot; };
  if (Status status = find_unseen(ids, is_unseen); !status.ok()) return status;
  for (std::size_t i = 0; i < ids.size(); ++i) boxes[i] = boxes_.boxes()[seen.find(ids[i])];
  return {};
}

Status Bodies::next_boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (Status status = find_unknown(table_, ids); !status.ok()) return status;
  for (std::size_t i = 0; i < ids.size(); ++i) boxes[i] = boxes_.next_box(table_.find(ids[i]));
  return {};
}

std::vector<BodyId> Bodies::removed_ids() const {
  std::vector<BodyId> ids;
  ids.reserve(boxes_.removed().size());
  for (const Slot slot : boxes_.removed()) ids.push_back(table_.id(slot));
  sort_numbers(ids);
  std::vector<BodyId> stayed;
  for (const auto& [from, to] : filters_.moves()) {
    if (table_.find(table_.id(from)) == to) stayed.push_back(table_.id(from));
  }
  sort_numbers(stayed);
  std::vector<BodyId> gone;
  std::set_difference(ids.begin(), ids.end(), stayed.begin(), stayed.end(), std::back_inserter(gone));
  return gone;
}

BodyChanges Bodies::begin_update() {
  if (some_unseen_) inserted_.erase_if([&](Slot slot) { return boxes_.state(slot) == kGone; });
  some_unseen_ = false;
  BodyChanges changes = boxes_.begin_update();
  changes.inserted = inserted_;
  changes.bodies = size();
  changes.filters = filters_.view();
  changes.ids_ascend = table_.is_ascending();
  return changes;
}

void Bodies::undo() {
  boxes_.undo();
}

void Bodies::commit() {
  boxes_.commit(inserted_);
  inserted_.clear();
  if (boxes_.has_come_to_rest()) {
    for (List<Slot>* list : {&inserted_, &moved_, &slots_}) *list = {};
  }
  filters_.commit();
  if (!table_.removed().empty()) choice_.note_freed();
  table_.release();
  if (table_.slot_count() > 0 || boxes_.slots() == 0) return;
  // With nobody left all memory goes back. The table goes on counting its versions.
  IdTable table = std::move(table_);
  *this = Bodies();
  table_ = std::move(table);
}

BodyChanges Bodies::all_as_new() {
  const std::span<const Aabb> boxes = boxes_.boxes();
  slots_.clear();
  slots_.reserve(size());
  for (Slot slot = 0; slot < boxes.size(); ++slot) {
    if (boxes[slot].min[0] <= boxes[slot].max[0]) slots_.push(slot);
  }
  return {boxes, {}, {}, {}, slots_, size(), filters_.view()};
}

bool Bodies::tidy() {
  if (!table_.is_sparse()) return false;
  List<Slot> before;
  IdTable table = table_.renumbered(before);
  SlotFilters filters = filters_.renumbered(before);
  boxes_.renumber(before);
  filters_ = std::move(filters);
  table_ = std::move(table);
  inserted_ = {};
  moved_ = {};
  slots_ = {};
  return true;
}

std::size_t Bodies::bytes() const {
  return table_.bytes() + boxes_.bytes() + filters_.bytes() + inserted_.bytes() + moved_.bytes() +
         slots_.bytes();
}

}  // namespace cellsweep
