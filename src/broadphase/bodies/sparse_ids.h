/// @file
/// Slots of ids that lie far apart: a table of open addresses, an id and its slot side by side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "cellsweep/pair.h"
#include "base/memory/memory.h"

namespace cellsweep::stream {

/// At most half full, linear probing, nothing left behind by an erase().
class SparseIds {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::size_t size() const { return size_; }

  /// The slot of an id, or kNone.
  std::uint32_t find(BodyId id) const { return size_ == 0 ? kNone : entries_[place_of(id)].slot; }

  /// Makes room for so many ids in all; insert() up to there takes no memory.
  void reserve(std::size_t ids) {
    if (2 * ids <= entries_.size()) return;
    std::size_t size = 64;
    while (size < 2 * ids) size *= 2;
    Vector<Entry> entries(size);
    entries.swap(entries_);
    for (const Entry& entry : entries) {
      if (entry.slot != kNone) entries_[place_of(entry.id)] = entry;
    }
  }

  /// An id that is not there.
  void insert(BodyId id, std::uint32_t slot) {
    reserve(size_ + 1);
    entries_[place_of(id)] = {id, slot};
    ++size_;
  }

  /// An id that is there. What was pushed out of its place by it moves back.
  void erase(BodyId id) {
    std::size_t hole = place_of(id);
    for (std::size_t next = after(hole); entries_[next].slot != kNone; next = after(next)) {
      const std::size_t from_home = (next - home_of(entries_[next].id)) & (entries_.size() - 1);
      const std::size_t from_hole = (next - hole) & (entries_.size() - 1);
      if (from_home < from_hole) continue;
      entries_[hole] = entries_[next];
      hole = next;
    }
    entries_[hole] = {};
    --size_;
  }

  std::size_t bytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    BodyId id = 0;
    std::uint32_t slot = kNone;
  };

  std::size_t home_of(BodyId id) const { return mix64(id) & (entries_.size() - 1); }
  std::size_t after(std::size_t place) const { return (place + 1) & (entries_.size() - 1); }

  // Where the id is, or the first free place that it could have.
  std::size_t place_of(BodyId id) const {
    std::size_t place = home_of(id);
    while (entries_[place].slot != kNone && entries_[place].id != id) place = after(place);
    return place;
  }

  Vector<Entry> entries_;  // a power of two, or none
  std::size_t size_ = 0;
};

}  // namespace cellsweep::stream
