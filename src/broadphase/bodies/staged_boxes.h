/// @file
/// The boxes of bodies by slot: those of the last update, and those that the next one brings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/list.h"
#include "base/memory/slot_blocks.h"
#include "base/threads/crew.h"
#include "base/tuning.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// What becomes of a slot with the next update.
enum BodyState : std::uint8_t {
  kAtRest,    ///< the body stays where it is
  kMoved,     ///< it gets another box
  kInserted,  ///< no update has seen it
  kGone       ///< it was removed, or nobody was ever there
};

/// The bodies of a call that were found to be held, and the boxes that they get.
struct MovedBodies {
  std::span<const Slot> slots;
  std::span<const Aabb> boxes;  ///< valid
  bool clean = false;           ///< and canonical as they are
  bool ascends = false;         ///< each slot is above the one before: none is there twice
};

/// Two boxes for each slot that changes, and for all while many do. begin_update() makes the next boxes those
/// that count; then either commit() forgets the others or undo() brings them back, and none of the three can
/// fail. What throws std::bad_alloc has changed nothing.
class StagedBoxes {
 public:
  std::size_t slots() const { return boxes_.size(); }
  BodyState state(Slot slot) const { return states_[slot]; }
  const BodyState* states() const { return states_.data(); }
  /// As of the last update; of a body that none has seen the one that it begins with.
  std::span<const Aabb> boxes() const { return boxes_.view(); }
  /// Bodies of the last update that were removed since.
  std::span<const Slot> removed() const { return removed_.view(); }

  /// Whether bodies of consecutive slots are at rest, and have these boxes.
  bool are_at_rest(Slot first, std::span<const Aabb> boxes) const;

  /// The box that the next update will bring, of a body that is held.
  const Aabb& next_box(Slot slot) const { return states_[slot] == kMoved ? next_[slot] : boxes_[slot]; }

  /// Makes room for so many slots in all: what inserts takes no memory then.
  void reserve(std::size_t slots);
  /// New slots come behind all others, in order; those that were free before are anywhere.
  void insert(std::span<const Slot> slots, std::span<const Aabb> boxes);
  /// Copies boxes to where the next slots will be, for which there is room, and says whether they are valid
  /// and canonical as they are. They count once they are inserted.
  bool stage(Crew& crew, std::span<const Aabb> boxes);
  /// So many as were staged by the last call of all, which were clean, into the next slots.
  void insert_staged(std::size_t count);

  /// The last box of several for a body counts.
  void move(Crew& crew, const MovedBodies& bodies);

  /// Makes room for so many calls of remove(), which take no memory then.
  void reserve_removals(std::size_t count);
  void remove(Slot slot);

  /// Without the new bodies and the number of all.
  BodyChanges begin_update();
  void undo();
  /// `inserted` have been seen from now on.
  void commit(std::span<const Slot> inserted);
  /// The last commit() gave memory back that had been of no use for some updates, for few bodies were named.
  bool has_come_to_rest() const { return quiet_ == tuning::kQuietToGiveBack; }

  /// Slots are numbered anew: each gets what slot `before[slot]` had. Nothing may wait for an update.
  void renumber(std::span<const Slot> before);

  [[gnu::cold]] std::size_t bytes() const;

 private:
  void reserve_next(std::size_t more);
  std::size_t move_share(const MovedBodies& bodies, Share share, Slot* moved);
  Slot* move_block(const MovedBodies& block, Slot* moved);
  bool are_at_rest(Slot first, std::size_t count) const;
  void swap_all();
  void swap_changed();
  [[gnu::cold]] void give_back();

  List<Aabb> boxes_;
  // Of those that moved, and kNobody of those that were removed; during an update, before.
  SlotBlocks<Aabb> next_;
  List<BodyState> states_;
  List<Slot> moved_;
  List<Slot> removed_;
  bool some_moved_are_gone_ = false;
  bool swapped_all_ = false;  // by begin_update()
  std::uint32_t quiet_ = 0;   // updates since many bodies were named
};

}  // namespace cellsweep
