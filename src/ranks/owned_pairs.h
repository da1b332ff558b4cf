/// @file
/// Which of the pairs that this rank's engine found are this rank's, under their global names.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/ranks.h"
#include "ranks/cuts.h"
#include "ranks/held_bodies.h"

namespace cellsweep::ranks {

/// A pair is found by one rank alone, and is its own, unless both bodies have links.
class OwnedPairs {
 public:
  OwnedPairs(const HeldBodies& held, int rank) : held_(held), rank_(rank) {}

  /// Those that began with the next update, in the regions that it brings; ascending. `engine` are the
  /// engine's. May throw std::bad_alloc, as the others may.
  void list_began(std::span<const Pair> engine, const Cuts& cuts, std::vector<GlobalPair>& began) const;
  /// Those that ended, in the regions of before.
  void list_ended(std::span<const Pair> engine, const Cuts& before, std::vector<GlobalPair>& ended) const;
  /// All as of the last update.
  void list_all(std::span<const Pair> engine, const Cuts& before, std::vector<GlobalPair>& pairs) const;

 private:
  template <class IsMine>
  void list(std::span<const Pair> engine, const IsMine& is_mine, std::vector<GlobalPair>& pairs) const;

  const HeldBodies& held_;
  int rank_;
};

}  // namespace cellsweep::ranks
