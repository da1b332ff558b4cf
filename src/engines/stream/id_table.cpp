#include "engines/stream/id_table.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace cellsweep::stream {
namespace {

/// A direct table may have this many entries for each body.
constexpr std::size_t kDirectEntries = 4;
constexpr std::size_t kSmallTable = 1024;

}  // namespace

std::uint32_t IdTable::find_sparse(BodyId id) const {
  const auto found = sparse_.find(id);
  return found == sparse_.end() ? kNone : found->second;
}

void IdTable::reserve_for(std::span<const BodyId> ids) {
  if (ids.empty()) return;
  const std::size_t bodies = size_ + ids.size();
  const std::size_t entries = std::size_t{*std::max_element(ids.begin(), ids.end())} + 1;
  if (entries > direct_.size() && entries <= kDirectEntries * bodies + kSmallTable) {
    direct_.resize(entries, kNone);
  }
  ids_.reserve(ids_.size() + ids.size());
}

void IdTable::set_slot(BodyId id, std::uint32_t slot) {
  if (id < direct_.size()) {
    direct_[id] = slot;
  } else {
    sparse_[id] = slot;
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

std::uint32_t IdTable::remove(BodyId id) {
  std::uint32_t slot = kNone;
  if (id < direct_.size() && direct_[id] != kNone) {
    slot = direct_[id];
    direct_[id] = kNone;
  } else {
    const auto found = sparse_.find(id);
    slot = found->second;
    sparse_.erase(found);
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

std::vector<std::uint32_t> IdTable::renumber() {
  std::vector<std::uint32_t> before;
  before.reserve(size_);
  for (std::uint32_t slot = 0; slot < ids_.size(); ++slot) {
    if (find(ids_[slot]) == slot) before.push_back(slot);
  }
  IdTable fresh;
  std::vector<BodyId> ids;
  ids.reserve(before.size());
  for (const std::uint32_t slot : before) ids.push_back(ids_[slot]);
  fresh.reserve_for(ids);
  for (const BodyId id : ids) fresh.insert(id);
  *this = std::move(fresh);
  return before;
}

std::size_t IdTable::bytes() const {
  constexpr std::size_t kSparseEntry = 40;
  return (ids_.capacity() + direct_.capacity() + free_.capacity() + removed_.capacity()) * sizeof(BodyId) +
         sparse_.size() * kSparseEntry;
}

}  // namespace cellsweep::stream
