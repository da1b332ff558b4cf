#include "broadphase/pair_tracker.h"

#include <algorithm>

namespace cellsweep {

PairChanges PairTracker::commit() {
  began_.clear();
  ended_.clear();
  keep_last_words();
  for (const Note& note : notes_) {
    const bool overlapped = places_.contains(note.key);
    if (note.overlapping == overlapped) continue;
    const Pair pair{static_cast<BodyId>(note.key >> 32), static_cast<BodyId>(note.key)};
    if (note.overlapping) {
      add(pair);
      began_.push_back(pair);
    } else {
      drop(pair);
      ended_.push_back(pair);
    }
  }
  notes_.clear();
  return {began_, ended_};
}

// Leaves one note a pair, the last one, in ascending order of pairs.
void PairTracker::keep_last_words() {
  std::stable_sort(notes_.begin(), notes_.end(),
                   [](const Note& one, const Note& other) { return one.key < other.key; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < notes_.size(); ++i) {
    const bool is_last = i + 1 == notes_.size() || notes_[i + 1].key != notes_[i].key;
    if (is_last) notes_[kept++] = notes_[i];
  }
  notes_.resize(kept);
}

void PairTracker::add(Pair pair) {
  places_.emplace(pair_key(pair), pairs_.size());
  pairs_.push_back(pair);
}

void PairTracker::drop(Pair pair) {
  const auto found = places_.find(pair_key(pair));
  const std::size_t place = found->second;
  places_.erase(found);
  const Pair last = pairs_.back();
  pairs_.pop_back();
  if (last == pair) return;
  pairs_[place] = last;
  places_[pair_key(last)] = place;
}

}  // namespace cellsweep
