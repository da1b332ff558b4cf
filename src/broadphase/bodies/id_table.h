/// @file
/// The bodies of a broadphase: a slot for each id, found by one load where ids are dense.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/list.h"
#include "base/threads/crew.h"
#include "base/threads/deferred.h"
#include "broadphase/bodies/sparse_ids.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Maps ids, any 32-bit numbers, to slots 0 ... slot_count() - 1 and back. The slot of a removed body keeps
/// its id until release(), so that the pairs which end with it can still be named.
class IdTable {
 public:
  /// Bodies held.
  std::size_t size() const { return size_; }
  /// Slots in use, freed or waiting for release().
  std::size_t slot_count() const { return ids_.size(); }

  /// The slot of a body, or kNoSlot. From any number of threads, while nothing else is called. Throws
  /// std::bad_alloc where a table is to be made for it, and nothing has changed.
  Slot find(BodyId id) const {
    if (id < direct_.size() && direct_[id] != kNoSlot) return direct_[id];
    make_table();
    return sparse_.find(id);
  }

  /// False after insert() of one large batch of scattered ids until one of them is looked up: bodies that are
  /// named again in the order in which they came need no table.
  bool has_table() const { return !table_.waits(); }

  /// Has the memory ready in which find() will look, where there is a table.
  void prefetch(BodyId id) const {
    if (id >= direct_.size() && has_table()) sparse_.prefetch(id);
  }

  /// Adds bodies and appends the slots that they get. False, and nothing has changed, when one is held or
  /// listed twice. By all workers, where there is work for them; without a crew by this thread. Throws
  /// std::bad_alloc before anything has changed.
  bool insert(Crew& crew, std::span<const BodyId> ids, List<Slot>& slots);
  bool insert(std::span<const BodyId> ids, List<Slot>& slots);

  /// The slot that insert() gives out next when it has given out so many.
  Slot next_slot(std::size_t before) const {
    return before < free_.size() ? free_[free_.size() - 1 - before]
                                 : static_cast<Slot>(ids_.size() + before - free_.size());
  }

  /// Makes room for removing so many: remove(), renew_slot() and release() take no memory then.
  void reserve_removals(std::size_t count);

  /// Gives a body that is held another slot, as if it had been removed and inserted again; returns it. Takes
  /// no memory after reserve_removals() and reserve_slots().
  Slot renew_slot(Slot slot);
  /// Makes room for so many slots in all.
  void reserve_slots(std::size_t slots) { ids_.reserve(slots); }

  /// Removes a body that is held, in this slot.
  void remove(Slot slot);

  /// Slots of removed bodies, which wait for release().
  std::span<const Slot> removed() const { return removed_.view(); }

  /// They are free from now on. With no body left, all memory is given back.
  void release();

  /// True when so many slots are free that slots should be numbered anew.
  bool is_sparse() const { return ids_.size() > 1024 && size_ < ids_.size() / 4; }

  /// A table of the same bodies with slots 0 ... size() - 1; `before` becomes for each the slot that it had.
  /// Nothing may wait for release().
  [[gnu::cold]] IdTable renumbered(List<Slot>& before) const;

  BodyId id(Slot slot) const { return ids_[slot]; }
  /// By slot; of a free slot the id that it had.
  const BodyId* ids() const { return ids_.data(); }

  /// True when each id is its own slot.
  bool is_identical() const { return identical_; }
  /// True when slots are in the order of their ids.
  bool is_ascending() const { return ascending_; }
  /// True when the next bodies get slots behind all others, in order.
  bool appends() const { return free_.empty(); }
  /// True when there is a body in every slot.
  bool is_full() const { return size_ == ids_.size(); }
  /// Counts what changes about which id belongs to which slot.
  std::uint64_t version() const { return version_; }

  /// Bytes held, nearly.
  [[gnu::cold]] std::size_t bytes() const;

 private:
  void reserve_for(std::span<const BodyId> ids);
  void make_table() const;
  bool can_wait_for_table(std::span<const BodyId> ids) const;
  void grow_direct(std::span<const BodyId> ids);
  bool map(BodyId id, Slot slot);
  void unmap(BodyId id);
  bool map_all(Crew& crew, std::span<const BodyId> ids);
  bool map_run(std::span<const BodyId> ids);
  bool is_new_run(std::span<const BodyId> ids) const;
  void insert_new_run(std::span<const BodyId> ids, List<Slot>& slots);
  void append(std::span<const BodyId> ids, List<Slot>& slots, bool consecutive);
  void take_slot(BodyId id);

  std::size_t size_ = 0;
  bool identical_ = true;
  bool ascending_ = true;
  std::uint64_t version_ = 0;
  List<BodyId> ids_;
  List<Slot> direct_;         // slots of ids below its size
  mutable SparseIds sparse_;  // and of the others,
  Deferred table_;            // once somebody looks one up
  List<Slot> free_;           // the last is given out first
  List<Slot> removed_;        // until release()
};

}  // namespace cellsweep
