#include "broadphase/bodies/id_table.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/sorting/key_sort.h"
#include "base/tuning.h"
#include "broadphase/bodies/distinct_ids.h"

namespace cellsweep {
namespace {

/// A direct table may have this many entries for each body.
constexpr std::size_t kDirectEntries = 4;
constexpr std::size_t kSmallTable = 1024;

/// Whether each id is one more than the one before.
bool are_consecutive(std::span<const BodyId> ids) {
  if (!ids.empty() && ids.back() - ids.front() != ids.size() - 1) return false;
  BodyId differs = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) differs |= ids[i] ^ (ids[0] + static_cast<BodyId>(i));
  return differs == 0 && (ids.empty() || ids.front() <= ids.back());
}

void append_numbers(List<Slot>& numbers, std::size_t count, Slot first) {
  numbers.reserve(numbers.size() + count);
  std::iota(numbers.end(), numbers.end() + count, first);
  numbers.set_size(numbers.size() + count);
}

/// So many bodies are worth a direct table of so many entries.
std::size_t direct_entries(std::size_t bodies) {
  return std::min(kDirectEntries * bodies + kSmallTable, std::size_t{std::numeric_limits<BodyId>::max()});
}

/// Whether a good part of them seem to be: a few tell ids that lie far apart.
bool many_are_below(BodyId most, std::span<const BodyId> ids) {
  constexpr std::size_t kLooks = 32;
  const std::size_t step = ids.size() / kLooks + 1;
  std::size_t below = 0;
  std::size_t looks = 0;
  for (std::size_t i = 0; i < ids.size(); i += step) {
    below += ids[i] < most ? 1 : 0;
    ++looks;
  }
  return 4 * below > looks;
}

}  // namespace

// As far as most of the ids reach.
void IdTable::grow_direct(std::span<const BodyId> ids) {
  const auto most = static_cast<BodyId>(direct_entries(size_ + ids.size()));
  if (!many_are_below(most, ids)) return;
  std::uint32_t count = 0;
  BodyId largest = 0;
  for (const BodyId id : ids) {
    count += id < most ? 1 : 0;
    largest = std::max(largest, id < most ? id : 0);
  }
  const std::size_t entries = std::size_t{largest} + 1;
  if (2 * std::size_t{count} < ids.size() || entries <= direct_.size()) return;
  direct_.reserve(entries);
  direct_.resize(entries, kNoSlot);
}

void IdTable::make_table() const {
  table_.finish([&] {
    sparse_.reserve(ids_.size());
    sparse_.insert_run(ids_, 0);
  });
}

// The first bodies, with many ids that are far apart.
bool IdTable::can_wait_for_table(std::span<const BodyId> ids) const {
  return ids_.empty() && direct_.empty() && ids.size() >= tuning::kTableWaits;
}

void IdTable::reserve_for(std::span<const BodyId> ids) {
  make_table();
  grow_direct(ids);
  ids_.reserve(ids_.size() + ids.size());
  if (can_wait_for_table(ids)) return;
  const auto is_sparse_id = [&](BodyId id) { return id >= direct_.size(); };
  const auto sparse = direct_.empty()
                          ? ids.size()
                          : static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), is_sparse_id));
  if (sparse > 0) sparse_.reserve(sparse_.size() + sparse);
}

// False when the id is there.
inline bool IdTable::map(BodyId id, Slot slot) {
  if (id >= direct_.size()) return sparse_.insert(id, slot);
  Slot& entry = direct_[id];
  if (entry != kNoSlot || sparse_.find(id) != kNoSlot) return false;
  entry = slot;
  return true;
}

void IdTable::unmap(BodyId id) {
  if (id < direct_.size() && direct_[id] != kNoSlot) {
    direct_[id] = kNoSlot;
  } else {
    sparse_.erase(id);
  }
}

void IdTable::take_slot(BodyId id) {
  const Slot slot = next_slot(0);
  identical_ = identical_ && slot == id;
  if (free_.empty()) {
    ascending_ = ascending_ && (ids_.empty() || ids_[ids_.size() - 1] < id);
    ids_.push(id);
  } else {
    free_.pop();
    ids_[slot] = id;
    ascending_ =
        ascending_ && (slot == 0 || ids_[slot - 1] < id) && (slot + 1 == ids_.size() || id < ids_[slot + 1]);
  }
  ++size_;
}

bool IdTable::insert(std::span<const BodyId> ids, List<Slot>& slots) {
  Crew alone(nullptr, 1, Crew::Choice::given);
  return insert(alone, ids, slots);
}

bool IdTable::insert(Crew& crew, std::span<const BodyId> ids, List<Slot>& slots) {
  if (is_new_run(ids)) {
    insert_new_run(ids, slots);
    return true;
  }
  reserve_for(ids);
  slots.reserve(slots.size() + ids.size());
  if (!map_all(crew, ids)) return false;
  ++version_;
  if (free_.empty()) {
    append(ids, slots, are_consecutive(ids));
    return true;
  }
  for (const BodyId id : ids) {
    slots.push(next_slot(0));
    take_slot(id);
  }
  return true;
}

// Consecutive ids behind all entries of the direct table, the only one in use.
bool IdTable::is_new_run(std::span<const BodyId> ids) const {
  return !ids.empty() && free_.empty() && sparse_.size() == 0 && has_table() &&
         ids.front() >= direct_.size() && ids.back() < direct_entries(size_ + ids.size()) &&
         are_consecutive(ids);
}

void IdTable::insert_new_run(std::span<const BodyId> ids, List<Slot>& slots) {
  direct_.reserve(std::size_t{ids.back()} + 1);
  ids_.reserve(ids_.size() + ids.size());
  slots.reserve(slots.size() + ids.size());
  direct_.resize(ids.front(), kNoSlot);
  append_numbers(direct_, ids.size(), next_slot(0));
  ++version_;
  append(ids, slots, true);
}

// All of them behind those that there are.
void IdTable::append(std::span<const BodyId> ids, List<Slot>& slots, bool consecutive) {
  const auto first = static_cast<Slot>(ids_.size());
  bool identical = identical_;
  bool ascending = ascending_ && (first == 0 || ids.empty() || ids_[first - 1] < ids[0]);
  if (consecutive) {
    identical = identical && (ids.empty() || ids[0] == first);
  } else {
    identical = false;
    ascending = ascending && std::ranges::adjacent_find(ids, std::ranges::greater_equal{}) == ids.end();
  }
  identical_ = identical;
  ascending_ = ascending;
  ids_.append(ids);
  size_ += ids.size();
  append_numbers(slots, ids.size(), first);
}

// Maps all ids to the slots that they will get, or none.
bool IdTable::map_all(Crew& crew, std::span<const BodyId> ids) {
  if (map_run(ids)) return true;
  if (can_wait_for_table(ids)) {
    if (!are_distinct(crew, ids)) return false;
    table_.put_off();
    return true;
  }
  if (direct_.empty() && free_.empty()) {
    const std::size_t mapped = sparse_.insert_run(ids, next_slot(0));
    if (mapped == ids.size()) return true;
    for (const BodyId id : ids.first(mapped)) unmap(id);
    return false;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (sparse_.size() > 0 && i + tuning::kIdsAhead < ids.size()) prefetch(ids[i + tuning::kIdsAhead]);
    if (map(ids[i], next_slot(i))) continue;
    for (const BodyId id : ids.first(i)) unmap(id);
    return false;
  }
  return true;
}

// Consecutive ids that find their entries of the direct table free. False, and nothing has changed, for
// others.
bool IdTable::map_run(std::span<const BodyId> ids) {
  if (ids.empty() || !free_.empty() || sparse_.size() > 0 || !are_consecutive(ids)) return false;
  if (ids.back() >= direct_.size()) return false;
  const auto entries = std::span(direct_).subspan(ids.front(), ids.size());
  if (!std::ranges::all_of(entries, [](Slot slot) { return slot == kNoSlot; })) return false;
  std::iota(entries.begin(), entries.end(), next_slot(0));
  return true;
}

void IdTable::reserve_removals(std::size_t count) {
  make_table();
  removed_.reserve(removed_.size() + count);
  free_.reserve(free_.size() + removed_.size() + count);
}

void IdTable::remove(Slot slot) {
  unmap(ids_[slot]);
  removed_.push(slot);
  --size_;
  ++version_;
}

Slot IdTable::renew_slot(Slot slot) {
  const BodyId id = ids_[slot];
  const Slot next = next_slot(0);
  unmap(id);
  map(id, next);
  take_slot(id);
  removed_.push(slot);
  --size_;
  ++version_;
  return next;
}

void IdTable::release() {
  if (removed_.empty()) return;
  if (size_ == 0) {
    const std::uint64_t version = version_;
    *this = IdTable();
    version_ = version + 1;
    return;
  }
  // The lowest slots are given out first: they make ids and slots alike where that is possible.
  sort_numbers(removed_);
  std::ranges::reverse(removed_);
  free_.append(removed_);
  removed_.clear();
}

IdTable IdTable::renumbered(List<Slot>& before) const {
  before.clear();
  before.reserve(size_);
  List<BodyId> ids;
  ids.reserve(size_);
  for (Slot slot = 0; slot < ids_.size(); ++slot) {
    if (find(ids_[slot]) != slot) continue;
    before.push(slot);
    ids.push(ids_[slot]);
  }
  IdTable fresh;
  List<Slot> slots;
  fresh.insert(ids, slots);
  fresh.version_ = version_ + 1;
  return fresh;
}

std::size_t IdTable::bytes() const {
  return ids_.bytes() + direct_.bytes() + free_.bytes() + removed_.bytes() + sparse_.bytes();
}

}  // namespace cellsweep
