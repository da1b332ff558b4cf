/// @file
/// The pairs of overlapping fat boxes of engine `stream`, ascending, and how they change.
#pragma once

#include <span>
#include <vector>

#include "base/crew.h"
#include "base/memory/array.h"
#include "base/pair_sort.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep::stream {

/// Two ascending lists.
struct SlotPairChanges {
  std::span<const SlotPair> began;
  std::span<const SlotPair> ended;
};

/// What differs between two ascending lists; the memory is that of `began` and `ended`.
SlotPairChanges find_changes(std::span<const SlotPair> old, std::span<const SlotPair> now,
                             Array<SlotPair>& began, Array<SlotPair>& ended);

/// A set of pairs, kept in ascending order, so that it does not matter in which order they are found. The
/// keys that it is given stay where they are until the next call.
class CandidateList {
 public:
  /// The pairs are now those of `found`, in any order, each once. They are sorted when pairs() is asked for.
  void replace(KeyParts found) { found_.assign(found.begin(), found.end()); }

  /// Pairs began and ended, in any order; one that is in both lists did neither.
  SlotPairChanges change(Crew& crew, KeyParts began, KeyParts ended);

  /// Ascending.
  std::span<const SlotPair> pairs(Crew& crew);

  std::size_t size() const;

  /// Bytes held.
  std::size_t bytes() const;

 private:
  void apply_changes();

  std::vector<std::span<const std::uint64_t>> found_;  // the pairs, when they have not been sorted yet
  Array<SlotPair> pairs_;
  Array<SlotPair> spare_;  // room for the next
  Array<SlotPair> began_;
  Array<SlotPair> ended_;
  Array<std::uint64_t> keys_;
};

}  // namespace cellsweep::stream
