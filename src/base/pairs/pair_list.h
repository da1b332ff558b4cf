/// @file
/// An ascending list of pairs that changes a little at a time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/pairs/pair_changes.h"
#include "base/sorting/stepped_sort.h"
#include "cellsweep/engine/engine.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Changes are noted, and wait until somebody asks for the list. Where they become many, they are brought
/// into it meanwhile, but a part at a time: in no call is the whole list walked that does not ask for it.
/// `AnyPair` is Pair or SlotPair. `spare` is working memory, always the same. What throws std::bad_alloc has
/// changed nothing that shows.
template <class AnyPair>
class PairList {
 public:
  /// Up to date.
  Array<AnyPair>& all(Array<AnyPair>& spare);

  /// But for the changes that wait; to be changed only while go_on() has taken none of them up.
  Array<AnyPair>& pairs() { return pairs_; }
  const Array<AnyPair>& pairs() const { return pairs_; }

  bool is_up_to_date() const { return notes_.empty() && stage_ == Stage::none; }

  /// Room for so many notes more, each of a pair that begins where it is not there and ends where it is.
  void reserve_notes(std::size_t more) { notes_.reserve(notes_.size() + more); }
  void note(std::uint64_t key) { notes_.push(key); }
  /// Those that go_on() has not taken up, and of these those since keep_notes() or go_on().
  std::size_t notes() const { return notes_.size(); }
  std::size_t new_notes() const { return notes_.size() - kept_; }
  void forget_new_notes() { notes_.set_size(kept_); }
  void keep_notes() { kept_ = notes_.size(); }
  /// The list will be another one.
  void forget_notes();

  /// Whether so many notes are many for a list of this length.
  static bool are_many(std::size_t notes, std::size_t pairs);
  /// Brings a part of them into the list, the greater the more of them are new: all are in it by the time
  /// that they are many again.
  void go_on(Array<AnyPair>& spare);
  /// In an update that changes nothing: of what go_on() has taken up, so much that it is all in the list
  /// before memory is given back. Cannot fail.
  void go_on_at_rest(Array<AnyPair>& spare);

  /// Gives back the memory that the list does not need, unless a part of its changes is in the next one.
  [[gnu::cold]] void give_back();

  std::size_t bytes() const { return pairs_.bytes() + next_.bytes() + notes_.bytes() + sort_.bytes(); }

 private:
  /// Of the changes that go_on() has taken up.
  enum class Stage : std::uint8_t { none, sorting, merging };

  [[gnu::cold]] void begin_merge(Array<AnyPair>& spare);
  [[gnu::noinline]] void merge(std::size_t steps, Array<AnyPair>& spare);
  [[gnu::noinline]] void list_noted(Array<AnyPair>& spare);

  Array<AnyPair> pairs_;
  List<std::uint64_t> notes_;  // keys, in the order in which they came,
  std::size_t kept_ = 0;       // so many of which are not new
  Stage stage_ = Stage::none;
  SteppedSort sort_;
  AlternatingMerge<AnyPair> merge_;  // of pairs_ with what was sorted, into
  Array<AnyPair> next_;
};

}  // namespace cellsweep
