/// @file
/// The checks of a move(): which bodies it names, and whether it is refused.
#pragma once

#include <cstddef>
#include <span>

#include "base/threads/crew.h"
#include "broadphase/bodies/id_table.h"
#include "broadphase/bodies/staged_boxes.h"
#include "cellsweep/aabb.h"

namespace cellsweep {

/// Who is held, and where; by slot.
struct HeldBodies {
  const IdTable& table;
  const StagedBoxes& boxes;
};

/// What one worker finds out about its share of a call. It changes nothing.
class MoveCheck {
 public:
  /// Writes the slots of the bodies. What `slots` held before is a guess: callers often name the same bodies
  /// in the same order again. Throws std::bad_alloc where IdTable::find() does.
  void run(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share,
           Slot* slots);

  /// No id is unknown, no box invalid. When false, the rest means nothing.
  bool good() const { return good_; }
  /// Every box is canonical as it is.
  bool clean() const { return clean_; }
  /// Every body is at rest and is given the box that it has.
  bool nobody_moves() const { return nobody_moves_; }
  /// Each body's slot is above the one before: none is there twice.
  bool ascends() const { return ascends_; }
  /// Slots of the first and the last body of the share.
  Slot first() const { return first_; }
  Slot last() const { return last_; }

 private:
  void check_block(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                   Slot* slots);
  bool find_slots(const HeldBodies& held, std::span<const BodyId> ids, Slot* slots);
  bool is_run(const HeldBodies& held, std::span<const BodyId> ids, Slot first) const;
  void note_run(Slot first, std::size_t count);
  bool note_slots(std::span<const Slot> slots);
  bool look_up(const HeldBodies& held, std::span<const BodyId> ids, Slot* slots);

  bool good_ = true;
  bool clean_ = true;
  bool ascends_ = true;
  bool nobody_moves_ = true;
  Slot first_ = kNoSlot;
  Slot last_ = kNoSlot;
  Slot next_ = 0;  // the slot behind the last one: callers often list bodies as they inserted them
};

}  // namespace cellsweep
