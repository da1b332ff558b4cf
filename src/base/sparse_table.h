/// @file
/// Places of ids that lie far apart: a table of open addresses, an id and its place side by side.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/tuning.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// At most half full, linear probing, nothing left behind by an erase(). Where an id goes depends on a key of
/// the table's own: nobody can choose ids that all go to one place. What it says does not depend on it.
/// `Id` is a number, `Rows<T>` a std::vector of some kind, `new_key` makes a key, which is not 0.
template <class Id, template <class> class Rows, std::uint64_t (*new_key)()>
class SparseTable {
 public:
  SparseTable() = default;
  /// For tests: with this key, which is not 0.
  explicit SparseTable(std::uint64_t key) : key_(key) {}

  std::size_t size() const { return size_; }

  /// The slot of an id, or kNoSlot.
  Slot find(Id id) const { return size_ == 0 ? kNoSlot : entries_[place_of(id)].slot; }

  /// Has the memory ready in which find() will look first.
  void prefetch(Id id) const {
    if (size_ > 0) __builtin_prefetch(&entries_[home_of(id)]);
  }

  /// Makes room for so many ids in all; insert() up to there takes no memory.
  void reserve(std::size_t ids) {
    if (2 * ids <= entries_.size()) return;
    std::size_t size = 64;
    while (size < 2 * ids) size *= 2;
    Rows<Entry> entries(size);
    if (key_ == 0) key_ = new_key();
    entries.swap(entries_);
    for (const Entry& entry : entries) {
      if (entry.slot != kNoSlot) entries_[place_of(entry.id)] = entry;
    }
  }

  /// Adds an id, for which there must be room; false when it is there.
  bool insert(Id id, Slot slot) {
    Entry& entry = entries_[place_of(id)];
    if (entry.slot != kNoSlot) return false;
    entry = {id, slot};
    ++size_;
    return true;
  }

  /// Adds ids, for which there must be room, to slots from `first` on, until one is there; returns how many
  /// it added.
  std::size_t insert_run(std::span<const Id> ids, Slot first) {
    return entries_.size() < tuning::kFarEntries ? insert_all<false>(ids, first)
                                                 : insert_all<true>(ids, first);
  }

  /// An id that is there. What was pushed out of its place by it moves back.
  void erase(Id id) {
    std::size_t hole = place_of(id);
    for (std::size_t next = after(hole); entries_[next].slot != kNoSlot; next = after(next)) {
      const std::size_t from_home = (next - home_of(entries_[next].id)) & (entries_.size() - 1);
      const std::size_t from_hole = (next - hole) & (entries_.size() - 1);
      if (from_home < from_hole) continue;
      entries_[hole] = entries_[next];
      hole = next;
    }
    entries_[hole] = {};
    --size_;
  }

  /// For tests: how many places an id is from the first one that it could have, at most.
  std::size_t longest_way() const {
    std::size_t longest = 0;
    for (std::size_t place = 0; place < entries_.size(); ++place) {
      if (entries_[place].slot == kNoSlot) continue;
      longest = std::max(longest, (place - home_of(entries_[place].id)) & (entries_.size() - 1));
    }
    return longest;
  }

  std::size_t bytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    Id id = 0;
    Slot slot = kNoSlot;
  };

  // Entries that are far are asked for some ids ahead.
  template <bool Far>
  std::size_t insert_all(std::span<const Id> ids, Slot first) {
    Entry* const entries = entries_.data();
    const std::size_t mask = entries_.size() - 1;
    const std::uint64_t key = key_;
    std::size_t done = 0;
    for (; done < ids.size(); ++done) {
      const Id id = ids[done];
      if (Far)
        __builtin_prefetch(
            &entries[hash_of(ids[std::min(done + tuning::kIdsAhead, ids.size() - 1)], key) & mask], 1);
      std::size_t place = hash_of(id, key) & mask;
      while (entries[place].slot != kNoSlot && entries[place].id != id) place = (place + 1) & mask;
      if (entries[place].slot != kNoSlot) break;
      entries[place] = {id, first + static_cast<Slot>(done)};
    }
    size_ += done;
    return done;
  }

  static std::uint64_t hash_of(Id id, std::uint64_t key) { return mix64(id ^ key); }
  std::size_t home_of(Id id) const { return hash_of(id, key_) & (entries_.size() - 1); }
  std::size_t after(std::size_t place) const { return (place + 1) & (entries_.size() - 1); }

  // Where the id is, or the first free place that it could have.
  std::size_t place_of(Id id) const {
    std::size_t place = home_of(id);
    while (entries_[place].slot != kNoSlot && entries_[place].id != id) place = after(place);
    return place;
  }

  Rows<Entry> entries_;  // a power of two, or none
  std::size_t size_ = 0;
  std::uint64_t key_ = 0;  // once there are entries
};

}  // namespace cellsweep
