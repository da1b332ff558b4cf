/// @file
/// The checks of a move(): which boxes are refused, which differ from those that bodies have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/crew.h"
#include "broadphase/bodies/id_table.h"
#include "cellsweep/aabb.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// What became of a body since the last update: at rest, or 1 + its place in the list of moved bodies.
using BodyState = std::uint32_t;
inline constexpr BodyState kAtRest = 0;
inline constexpr BodyState kInserted = 0xffffffff;  ///< and no update has seen it
inline constexpr BodyState kGone = 0xfffffffe;      ///< removed, or nobody was ever there

/// What the bodies have, by slot.
struct HeldBodies {
  const IdTable& table;
  const Aabb* boxes;  ///< of the last update, or of a body that none has seen
  const BodyState* states;
};

/// Whether boxes that bodies have already are left out of the list: right when no body is in the call twice,
/// for the last box counts, even one that is where the body was.
enum class Unmoved { left_out, kept };

/// What one worker finds out about its share of a call. It writes what is to be moved into its share of a
/// list, and changes nothing else.
class MoveCheck {
 public:
  /// `moved` has room for the whole share.
  void run(const HeldBodies& held, std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share,
           ChangedBody* moved, Unmoved unmoved);

  /// No id is unknown, no box invalid. When false, the rest means nothing.
  bool good() const { return good_; }
  /// Each body's slot is above the one before: none is there twice.
  bool ascends() const { return ascends_; }
  /// Slots of the first and the last body of the share.
  Slot first() const { return first_; }
  Slot last() const { return last_; }
  /// Bodies written to the list, with the boxes that they are to get.
  std::size_t moved() const { return static_cast<std::size_t>(to_ - list_); }

 private:
  void check_block(const HeldBodies& held, const BodyId* ids, std::span<const Aabb> boxes);
  bool find_slots(const HeldBodies& held, const BodyId* ids, std::size_t count, Slot* slots);
  void note_run(Slot first, std::size_t count);
  bool is_run(const HeldBodies& held, const BodyId* ids, std::size_t count, Slot first) const;
  Slot find(const HeldBodies& held, BodyId id);
  void list_all(const Slot* slots, std::span<const Aabb> boxes);
  void note(const HeldBodies& held, Slot slot, const Aabb& box);

  bool good_ = true;
  bool ascends_ = true;
  Slot first_ = 0;
  Slot last_ = 0;
  Unmoved unmoved_ = Unmoved::left_out;
  Slot next_ = 0;  // the slot behind the last one: callers often list bodies as they inserted them
  ChangedBody* list_ = nullptr;
  ChangedBody* to_ = nullptr;
};

}  // namespace cellsweep
