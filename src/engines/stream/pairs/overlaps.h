/// @file
/// The pairs of engine `stream`: candidates, whose fat boxes overlap, and which of them overlap themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/threads/crew.h"
#include "base/threads/work_cost.h"
#include "base/tuning.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/pairs/candidate_list.h"
#include "engines/stream/pairs/few_choice.h"
#include "engines/stream/pairs/overlap_marks.h"
#include "engines/stream/pairs/pair_room.h"
#include "engines/stream/pairs/pairs_of_few.h"
#include "engines/stream/pairs/resting_candidates.h"

namespace cellsweep::stream {

/// Brought up to date once in each update, in one of the ways below. `changes` are those of the update.
class Overlaps {
 public:
  explicit Overlaps(Crew& crew) : crew_(crew) {}

  /// From now on fat boxes may be larger than boxes, and candidates need not be pairs.
  void loosen() { are_pairs_ = false; }

  /// All will be found anew: what there is is kept for compare(). To be called before the search, whose
  /// memory may have it.
  [[gnu::noinline]] void set_aside(const BodyChanges& changes);
  /// The candidates are now those of `found`. `are_pairs` when fat boxes are the boxes themselves.
  void replace(KeyParts found, bool are_pairs);
  /// After replace(): what differs from the pairs before.
  FoundPairs compare(const BodyChanges& changes);
  /// Whether that is a list in the order of slots; the first pairs of all are not put in it, when they will
  /// have to be sorted by ids.
  bool are_in_order(const BodyChanges& changes) const;
  void put_in_order() { list_.sort_found(crew_); }

  /// Fat boxes for later changed, and their cells and what was found in them with these. False, and all that
  /// is of no use any more, when that takes more than to make them anew.
  [[gnu::cold]] bool change_prepared(const BodyChanges& changes, std::span<const FatBoxChange> fat_changes,
                                     CellTree& cells);
  /// Candidates for later, those of `found`, in buckets; sort_prepared() sorts them until a share, 0 to 1, is
  /// in order, and returns whether all is. Between set_aside() and compare(), use_prepared() puts them in the
  /// place of those that there are.
  void prepare(KeyParts found) {
    prepared_.replace(found);
    prepared_.begin_sort(crew_, before_);
  }
  bool sort_prepared(double share) { return prepared_.sort_until(crew_, share); }
  void use_prepared() { list_.swap(prepared_); }
  /// Forgets them, and their memory.
  [[gnu::cold]] void drop_prepared() { prepared_ = {}; }

  /// The next two are going to follow: those of two bodies that rest are walked in neither.
  void begin_walk(const BodyChanges& changes);
  /// Fat boxes changed, and the cells with them. Says which candidates began and ended, valid until the next
  /// update.
  SlotPairChanges change_candidates(const BodyChanges& changes, std::span<const FatBoxChange> fat_changes,
                                    const CellTree& cells);
  /// Tests the candidates, after they changed by `of_candidates`.
  [[gnu::noinline]] FoundPairs test(const BodyChanges& changes, const SlotPairChanges& of_candidates);

  /// Everything was found anew, which takes as many steps: the first update of few finds room for its marks.
  void make_room_for_few(const BodyChanges& changes);
  /// Whether so few bodies changed that the cells should be asked for their pairs. Once an update, which
  /// counts: FewChoice.
  bool choose_few(const BodyChanges& changes);
  /// Asks the cells, and changes them, one body at a time; then asks of the others that moved, in their fat
  /// boxes. These throw TooMuchWork; then forget_few() makes everything but the cells what it was,
  /// and all is to be found anew.
  void change_cells_of_few(CellTree& cells, const BodyChanges& changes,
                           std::span<const FatBoxChange> fat_changes);
  FoundPairs find_of_few(CellTree& cells, const BodyChanges& changes, const FatBoxes& fat_boxes);
  [[gnu::cold]] void forget_few(const BodyChanges& changes);

  /// Nobody is left: all pairs end, and the memory goes back.
  [[gnu::cold]] FoundPairs end_all(const BodyChanges& changes);

  /// No pairs, and no memory but what little is always kept.
  [[gnu::cold]] void clear();
  /// Gives memory back that the next update may ask for again; what was found may lie there no longer.
  [[gnu::cold]] void give_back();

  std::size_t candidates() const { return list_.size() + resting_.size(); }
  /// Comparisons of two boxes so far.
  std::uint64_t tests() const { return tests_; }
  [[gnu::cold]] std::size_t bytes() const;

 private:
  /// What the marks say of the update before.
  enum class Marks { all_overlap, true_of_it, stale };

  void reunite();
  void mark_fresh(const BodyChanges& changes, std::uint8_t mark);
  void mark_fresh(std::span<const FatBoxChange> fat_changes, std::uint8_t mark);
  void repair_marks(const BodyChanges& changes);
  void note(std::span<const std::uint64_t> keys, bool are_there);

  Crew& crew_;
  CandidateList list_;
  CandidateList prepared_;
  OverlapMarks marks_;
  RestingCandidates resting_;  // which are not in the list
  PairsOfFew few_;
  FewChoice few_choice_;
  bool are_pairs_ = true;  // all candidates
  Marks marks_say_ = Marks::all_overlap;
  PairRoom room_;
  Array<SlotPair> before_;    // the pairs that were replaced, until they were compared with those now
  Array<SlotPair> ended_;     // when nobody was left
  List<std::uint8_t> fresh_;  // by slot, 0 between updates
  std::uint64_t tests_ = 0;
  WorkCost test_cost_{tuning::kTestGuess};
};

}  // namespace cellsweep::stream
