/// @file
/// Keeps the current pairs of an engine that hears of single pairs, and finds out which began and ended.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "cellsweep/engine/engine.h"

namespace cellsweep {

/// Persistent results out of single events (X6). An engine notes what becomes of pairs, in any order and as
/// often as it likes; commit() makes the last word on each pair the current set.
class PairTracker {
 public:
  /// From now on this pair overlaps, or does not.
  void note(SlotPair pair, bool overlapping) { notes_.push_back({pair_key(pair), overlapping}); }

  /// Applies the notes and says what they changed. Cost: n log n in the notes, nothing in other pairs.
  FoundPairs commit() {
    began_.clear();
    ended_.clear();
    keep_last_words();
    for (const Note& note : notes_) {
      const SlotPair pair{static_cast<Slot>(note.key >> 32), static_cast<Slot>(note.key)};
      if (note.overlapping) {
        if (pairs_.insert(note.key).second) began_.push_back(pair);
      } else if (pairs_.erase(note.key) > 0) {
        ended_.push_back(pair);
      }
    }
    notes_.clear();
    return {.began = began_, .ended = ended_};
  }

  /// Pairs that overlap, as of the last commit().
  std::size_t size() const { return pairs_.size(); }

 private:
  struct Note {
    std::uint64_t key;
    bool overlapping;
  };
  struct MixedHash {
    std::size_t operator()(std::uint64_t key) const { return mix64(key); }
  };

  // Leaves one note a pair, the last one, in ascending order of pairs.
  void keep_last_words() {
    std::stable_sort(notes_.begin(), notes_.end(),
                     [](const Note& one, const Note& other) { return one.key < other.key; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < notes_.size(); ++i) {
      const bool is_last = i + 1 == notes_.size() || notes_[i + 1].key != notes_[i].key;
      if (is_last) notes_[kept++] = notes_[i];
    }
    notes_.resize(kept);
  }

  std::vector<Note> notes_;
  std::vector<SlotPair> began_;
  std::vector<SlotPair> ended_;
  std::unordered_set<std::uint64_t, MixedHash> pairs_;  // by pair_key()
};

}  // namespace cellsweep
