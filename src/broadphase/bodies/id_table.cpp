#include "broadphase/bodies/id_table.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace cellsweep::stream {
namespace {

/// A direct table may have this many entries for each body.
constexpr std::size_t kDirectEntries = 4;
constexpr std::size_t kSmallTable = 1024;

}  // namespace

void IdTable::reserve_for(std::span<const BodyId> ids) {
  if (ids.empty()) return;
  const std::size_t bodies = size_ + ids.size();
  const std::size_t entries = std::size_t{*std::max_element(ids.begin(), ids.end())} + 1;
  if (entries > direct_.size() && entries <= kDirectEntries * bodies + kSmallTable) {
    make_room(direct_, entries);
    direct_.resize(entries, kNone);
  }
  make_room(ids_, ids_.size() + ids.size());
  const auto is_sparse_id = [&](BodyId id) { return id >= direct_.size(); };
  const auto sparse = static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), is_sparse_id));
  if (sparse > 0) sparse_.reserve(sparse_.size() + sparse);
}

void IdTable::set_slot(BodyId id, std::uint32_t slot) {
  if (id < direct_.size()) {
    direct_[id] = slot;
  } else {
    sparse_.insert(id, slot);
  }
}

std::uint32_t IdTable::insert(BodyId id) {
  auto slot = static_cast<std::uint32_t>(ids_.size());
  if (free_.empty()) {
    ids_.push_back(id);
  } else {
    slot = free_.back();
    free_.pop_back();
    ids_[slot] = id;
  }
  identical_ = identical_ && slot == id;
  set_slot(id, slot);
  ++size_;
  return slot;
}

void IdTable::append(std::span<const BodyId> ids) {
  auto slot = static_cast<std::uint32_t>(ids_.size());
  ids_.insert(ids_.end(), ids.begin(), ids.end());
  bool identical = identical_;
  for (const BodyId id : ids) {
    identical &= slot == id;
    set_slot(id, slot++);
  }
  identical_ = identical;
  size_ += ids.size();
}

void IdTable::reserve_removals(std::size_t count) {
  make_room(removed_, removed_.size() + count);
  make_room(free_, free_.size() + removed_.size() + count);
}

std::uint32_t IdTable::remove(BodyId id) {
  std::uint32_t slot = kNone;
  if (id < direct_.size() && direct_[id] != kNone) {
    slot = direct_[id];
    direct_[id] = kNone;
  } else {
    slot = sparse_.find(id);
    sparse_.erase(id);
  }
  removed_.push_back(slot);
  --size_;
  return slot;
}

void IdTable::release() {
  if (removed_.empty()) return;
  if (size_ == 0) {
    *this = IdTable();
    return;
  }
  // The lowest slots are given out first: they make ids and slots alike where that is possible.
  std::sort(removed_.begin(), removed_.end(), std::greater<>());
  free_.insert(free_.end(), removed_.begin(), removed_.end());
  removed_.clear();
}

Vector<std::uint32_t> IdTable::renumber() {
  Vector<std::uint32_t> before;
  before.reserve(size_);
  for (std::uint32_t slot = 0; slot < ids_.size(); ++slot) {
    if (find(ids_[slot]) == slot) before.push_back(slot);
  }
  IdTable fresh;
  Vector<BodyId> ids;
  ids.reserve(before.size());
  for (const std::uint32_t slot : before) ids.push_back(ids_[slot]);
  fresh.reserve_for(ids);
  for (const BodyId id : ids) fresh.insert(id);
  *this = std::move(fresh);
  return before;
}

std::size_t IdTable::bytes() const {
  return (ids_.capacity() + direct_.capacity() + free_.capacity() + removed_.capacity()) * sizeof(BodyId) +
         sparse_.bytes();
}

}  // namespace cellsweep::stream
