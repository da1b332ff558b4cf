/// @file
/// The pairs of overlapping fat boxes of engine `stream`, ascending, and how they change.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/memory/array.h"
#include "base/pairs/pair_list.h"
#include "base/sorting/key_buckets.h"
#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/slots.h"
#include "engines/stream/pairs/pair_room.h"

namespace cellsweep::stream {

/// Two ascending lists.
struct SlotPairChanges {
  std::span<const SlotPair> began;
  std::span<const SlotPair> ended;
};

/// A set of pairs, kept in ascending order, so that it does not matter in which order they are found. The
/// keys that it is given must stay where they are until pairs() or take() was called. `room` is working
/// memory.
class CandidateList {
 public:
  [[gnu::cold]] void swap(CandidateList& other);

  /// No pairs: those that there were are in `taken`, whose memory the next ones get.
  void take(Crew& crew, PairRoom& room, Array<SlotPair>& taken);

  /// The pairs are now those of `found`, in any order, each once. They are sorted when pairs() is asked for.
  void replace(KeyParts found);

  /// After replace(), while nobody asked for pairs(): what it was given.
  KeyParts found() const { return found_; }
  /// Sorts it, if nobody asked for that yet.
  void sort_found(Crew& crew);

  /// After replace(): sorts them a part at a time. begin_sort() counts them, or does all of it where they are
  /// few; then sort_until() goes on until a share, 0 to 1, of the rest is done. True when all is, and then
  /// the keys may go. They will be in the memory of `spare`, which gets theirs.
  [[gnu::cold]] void begin_sort(Crew& crew, Array<SlotPair>& spare);
  [[gnu::cold]] bool sort_until(Crew& crew, double share);

  /// Some bodies changed, those whose entry in `changed`, by slot, is not 0: their pairs are now those of
  /// `touched`, in any order, each once. Returns what began and ended by that.
  SlotPairChanges change(Crew& crew, PairRoom& room, KeyParts touched, const std::uint8_t* changed);

  /// Some pairs are there from now on, or are not any more, but nobody asks what became of them: the list is
  /// brought up to date when that is asked for, and where much waits a part at a time by begin_notes().
  /// False, and nothing is noted, when more would have changed since begin_notes() than half of the list and
  /// some: forget_notes() makes it what it was then.
  void begin_notes(Crew& crew, PairRoom& room);
  bool note(std::span<const std::uint64_t> keys, bool are_there);
  [[gnu::cold]] void forget_notes();

  /// Ascending.
  std::span<const SlotPair> pairs(Crew& crew, PairRoom& room);

  /// The same, to be changed by whoever says afterwards that it was.
  Array<SlotPair>& all(Crew& crew, PairRoom& room);
  void note_change() { size_ = list_.pairs().size(); }

  std::size_t size() const { return size_; }
  /// Whether pairs() has something to do.
  bool waits() const { return !found_.empty() || !list_.is_up_to_date(); }

  /// Gives memory back that the next call may ask for again. The keys that it was given may go.
  [[gnu::cold]] void give_back(Crew& crew);

  /// Bytes held.
  std::size_t bytes() const;

 private:
  void list_pairs_of(Crew& crew, const std::uint8_t* changed, Array<SlotPair>& listed) const;

  std::vector<std::span<const std::uint64_t>> found_;  // the pairs, when they have not been sorted yet
  std::optional<KeyBuckets> buckets_;                  // of keys_, while these are being sorted,
  std::size_t buckets_sorted_ = 0;                     // and so many of them are
  PairList<SlotPair> list_;
  Array<SlotPair> began_;
  Array<SlotPair> ended_;
  Array<std::uint64_t> keys_;
  std::size_t size_ = 0;
  std::size_t size_before_ = 0;  // at begin_notes()
};

}  // namespace cellsweep::stream
