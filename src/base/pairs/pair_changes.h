/// @file
/// Ascending lists of pairs: what differs between two, and how one becomes the next.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/pair.h"

namespace cellsweep {

// `AnyPair` is Pair or SlotPair. Lists are ascending.

/// How many pairs of a list are below this one.
template <class AnyPair>
std::size_t count_below(std::span<const AnyPair> pairs, const AnyPair& pair) {
  return static_cast<std::size_t>(std::lower_bound(pairs.begin(), pairs.end(), pair) - pairs.begin());
}

/// What differs between two lists. Pairs of the numbers in `gone`, ascending, end and begin though they are
/// in both.
template <class AnyPair>
void find_changes(std::span<const AnyPair> old, std::span<const AnyPair> now,
                  std::span<const std::uint32_t> gone, Array<AnyPair>& began, Array<AnyPair>& ended);

/// Where pairs that began and ended are written, or how far that is done.
template <class AnyPair>
struct ChangeRoom {
  AnyPair* began;
  AnyPair* ended;
};

/// The same, written to a room for all of `now` and of `old`, which may be theirs. Returns the ends of what
/// was written.
template <class AnyPair>
ChangeRoom<AnyPair> write_changes(std::span<const AnyPair> old, std::span<const AnyPair> now,
                                  std::span<const std::uint32_t> gone, ChangeRoom<AnyPair> room);

/// Writes a list with some changes to `now`. What lies between two changes is copied as a whole, where these
/// are few. All that ended is in the old list.
template <class AnyPair>
void apply_changes(std::span<const AnyPair> old, std::span<const AnyPair> began,
                   std::span<const AnyPair> ended, Array<AnyPair>& now);

/// The same by all workers; nothing of the old list began.
template <class AnyPair>
void apply_changes(Crew& crew, std::span<const AnyPair> old, std::span<const AnyPair> began,
                   std::span<const AnyPair> ended, Array<AnyPair>& now);

/// The same with changes that alternate for each pair, as it begins and ends: their keys, ascending, each as
/// often as it changed.
template <class AnyPair>
void apply_alternating(std::span<const AnyPair> old, std::span<const std::uint64_t> keys,
                       Array<AnyPair>& now);

/// The same a part at a time.
template <class AnyPair>
class AlternatingMerge {
 public:
  AlternatingMerge() = default;
  /// `to` has room for as many pairs as there are in both.
  AlternatingMerge(std::span<const AnyPair> old, std::span<const std::uint64_t> keys, AnyPair* to)
      : old_(old), keys_(keys), to_(to) {}

  /// Goes on for about so many pairs of the old list, or so many keys. True when all is done.
  bool go_on(std::size_t steps);

  /// Of what was written.
  AnyPair* end() const { return to_; }

 private:
  std::span<const AnyPair> old_;
  std::span<const std::uint64_t> keys_;
  AnyPair* to_ = nullptr;
};

}  // namespace cellsweep
