/// @file
/// The pairs of a broadphase, ascending by id: what the last update changed, and on demand all of them.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/pairs/pair_list.h"
#include "base/threads/deferred.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// The whole list is brought up to date when somebody asks for it; until then changes are remembered, and
/// where they are many brought into it a part at a time. What throws std::bad_alloc has changed nothing that
/// shows.
class PairSet {
 public:
  /// Makes room for new changes: the last ones will be needed to list all pairs. Memory for many more pairs
  /// than there are goes back. Before next_began() and next_ended() are written.
  void remember_changes();

  /// Gives back all memory that the next changes may ask for again. Before remember_changes().
  [[gnu::cold]] void give_back() { give_back_room(0); }

  /// To be written by an update, ascending. Nothing of it shows before commit().
  Array<Pair>& next_began() { return next_began_; }
  Array<Pair>& next_ended() { return next_ended_; }

  /// Turns a whole set in next_began(), ascending, into what differs from the pairs of now. Pairs of bodies
  /// that are gone, ascending, end though others of their ids are in the set.
  void compare_with_whole_set(std::span<const BodyId> gone);

  /// What was written; the memory stays where it is in commit().
  PairChanges next_changes() const { return {next_began_.view(), next_ended_.view()}; }

  /// What was written is what changed last. Cannot fail.
  void commit();

  /// Nothing changed. Cannot fail.
  void commit_nothing();

  /// All pairs, ascending. From any number of threads, while nothing else is called.
  std::span<const Pair> pairs() const;

  /// Held. As pairs().
  [[gnu::cold]] std::size_t bytes() const;

 private:
  [[gnu::cold]] void give_back_room(std::size_t enough);
  void note_changes() const;
  void list_all() const;

  Array<Pair> began_;  // of the last update
  Array<Pair> ended_;
  Array<Pair> next_began_;
  Array<Pair> next_ended_;
  Array<Pair> whole_;  // what compare_with_whole_set() was given

  mutable PairList<Pair> list_;  // but for the last changes
  mutable Array<Pair> spare_;    // room for the next list
  Deferred listing_;             // of what changed last
  bool only_began_ = true;  // all pairs: the list of those that began is that of all, and nothing is copied
};

}  // namespace cellsweep
