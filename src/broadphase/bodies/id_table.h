/// @file
/// The bodies of engine `stream`: a slot for each id, found by one load where ids are dense.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "cellsweep/pair.h"
#include "broadphase/bodies/sparse_ids.h"
#include "base/memory/array.h"

namespace cellsweep::stream {

/// Maps ids, any 32-bit numbers, to slots 0 … slot_count() − 1 and back. The slot of a removed body keeps its
/// id until release(), so that the pairs which end with it can still be named.
class IdTable {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Bodies held.
  std::size_t size() const { return size_; }
  /// Slots in use, freed or waiting for release().
  std::size_t slot_count() const { return ids_.size(); }

  /// The slot of a body, or kNone.
  std::uint32_t find(BodyId id) const {
    if (id < direct_.size() && direct_[id] != kNone) return direct_[id];
    return sparse_.find(id);
  }

  /// Makes room for these bodies, none of which is held: inserting them takes no memory.
  void reserve_for(std::span<const BodyId> ids);

  /// The slot of a new body.
  std::uint32_t insert(BodyId id);

  /// True when new bodies get the slots from slot_count() on, in order.
  bool appends() const { return free_.empty(); }
  /// New bodies for which there is room, when appends().
  void append(std::span<const BodyId> ids);

  /// Makes room for removing so many: remove() and release() take no memory then.
  void reserve_removals(std::size_t count);

  /// The slot that a held body had.
  std::uint32_t remove(BodyId id);

  /// Slots of removed bodies are free from now on. With no body left, all memory is given back.
  void release();

  /// True when so many slots are free that slots should be numbered anew.
  bool is_sparse() const { return ids_.size() > 1024 && size_ < ids_.size() / 4; }

  /// Numbers the slots anew, 0 … size() − 1, and returns for each the slot that its body had. Frees what
  /// waited for release().
  Vector<std::uint32_t> renumber();

  BodyId id(std::uint32_t slot) const { return ids_[slot]; }

  /// Ids by slot; null when each is its own slot.
  const BodyId* ids() const { return identical_ ? nullptr : ids_.data(); }

  /// True when the ids are 0 … size() − 1, each its own slot.
  bool is_plain() const { return identical_ && size_ == ids_.size(); }

  /// Bytes held, nearly.
  std::size_t bytes() const;

 private:
  void set_slot(BodyId id, std::uint32_t slot);

  std::size_t size_ = 0;
  bool identical_ = true;
  Vector<BodyId> ids_;
  std::vector<std::uint32_t, Allocator<std::uint32_t>> direct_;  // slots of ids below its size
  SparseIds sparse_;                                             // and of the others
  Vector<std::uint32_t> free_;
  Vector<std::uint32_t> removed_;
};

}  // namespace cellsweep::stream
