/// @file
/// Ids for bodies whose owner has none.
#pragma once

#include <cstdint>
#include <span>

#include "broadphase/bodies/id_table.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Chooses ids for one table, and remembers what it was told of those that it has.
class IdChoice {
 public:
  /// Ids that nobody has, for so many bodies, which the table is to be given next: those of the slots that
  /// these get, where nobody has them; else below the table's slot_count() as it will be, while all of its
  /// ids have been chosen so. Throws std::bad_alloc, and nothing has changed.
  [[gnu::cold]] void choose(const IdTable& table, std::span<BodyId> ids);

  /// The table was given an id that was not chosen, or a body got another slot by itself.
  void note_other() { all_are_chosen_ = false; }
  /// Ids that were taken may not be from now on. Once nobody is left, another choice is to begin.
  void note_freed() { taken_from_ = taken_to_ = 0; }

 private:
  bool all_are_chosen_ = true;
  // All ids from the one to before the other are taken: choose() need not look at them again.
  BodyId taken_from_ = 0;
  BodyId taken_to_ = 0;
};

}  // namespace cellsweep
