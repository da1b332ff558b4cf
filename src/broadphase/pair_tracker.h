/// @file
/// Keeps the current pairs of an engine and finds out which began and which ended since the last update.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Persistent results out of single events (X6). An engine notes what becomes of pairs, in any order and as
/// often as it likes; commit() makes the last word on each pair the current set.
class PairTracker {
 public:
  /// From now on this pair overlaps, or does not.
  void note(Pair pair, bool overlapping) { notes_.push_back({pair_key(pair), overlapping}); }

  /// Applies the notes. Cost: n log n in the notes, nothing in the pairs that nobody noted.
  PairChanges commit();

  /// The set as of the last commit(), in an order that depends on the notes alone.
  std::span<const Pair> pairs() const { return pairs_; }

 private:
  struct Note {
    std::uint64_t key;
    bool overlapping;
  };
  struct MixedHash {
    std::size_t operator()(std::uint64_t key) const { return mix64(key); }
  };

  void keep_last_words();
  void add(Pair pair);
  void drop(Pair pair);

  std::vector<Note> notes_;
  std::vector<Pair> pairs_;
  std::vector<Pair> began_;
  std::vector<Pair> ended_;
  std::unordered_map<std::uint64_t, std::size_t, MixedHash> places_;  // pair key -> index in pairs_
};

}  // namespace cellsweep
