#include "engines/stream/choices/fat_box_choice.h"

#include <algorithm>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// Those of bodies that tremble reach further to either side each time, until they last. Of bodies that creep
/// those are left that turn, a few at a time, and are known to tremble then.
std::uint32_t updates_of_settling(const FatBoxWork& work) {
  return work.most_settle ? tuning::kUpdatesOfSettling : tuning::kUpdatesOfStart;
}

/// Of an update in which no fat box is left.
std::int64_t least_cost(std::size_t bodies, std::size_t candidates) {
  return static_cast<std::int64_t>(tuning::kFatBoxCost * bodies + tuning::kCandidateCost * candidates);
}

}  // namespace

bool FatBoxChoice::begin_update(Crew& crew, const BodyChanges& changes) {
  if (!may_go_without_) return false;
  note_size(changes.boxes.size());
  much_motion_ = do_most_move(changes) && !changes.moved.empty();
  if (!much_motion_) {
    is_without_ = is_without_ && changes.moved.empty();
    seen_ = 0;
    is_tried_ = false;
    return false;
  }
  if (is_without_ && is_small_) watch(changes);
  if (is_without_ && !is_small_) go_on_with_trial(crew, changes);
  return is_without_;
}

void FatBoxChoice::note_size(std::size_t slots) {
  const bool is_small = can_sweep_ && slots <= tuning::kMostSweptFirst;
  is_swept_ = can_sweep_ && slots <= tuning::kMostSweptInMotion;
  if (is_small == is_small_) return;
  is_small_ = is_small;
  try_fat_boxes();
  is_without_ = is_small;
  pause_ = 0;
  patience_ = 1;
}

void FatBoxChoice::note_anew(bool has_cells) {
  if (!is_swept_ || !has_cells) return;
  try_fat_boxes();
  pause_ = tuning::kPauseOfSweeps;
}

// Some bodies have fat boxes: that all bodies should is known as soon as these last.
void FatBoxChoice::go_on_with_trial(Crew& crew, const BodyChanges& changes) {
  crew.use(1);
  if (!is_tried_ || !trial_.go_on(crew, changes)) trial_.begin(changes);
  is_tried_ = true;
  if (trial_.updates() < tuning::kUpdatesTried) return;
  is_tried_ = false;
  const double most = is_swept_ ? tuning::kMostEscapesOfSwept : tuning::kMostEscapesOfTried;
  if (trial_.share_escaped() <= most) try_fat_boxes();
}

void FatBoxChoice::try_fat_boxes() {
  is_without_ = false;
  is_tried_ = false;
  seen_ = 0;
  stays_ = 0;
  settled_ = 0;
  judged_ = 0;
  excess_ = 0;
  lasted_ = 0;
}

// After so many updates the verdict, and anew.
void FatBoxChoice::watch(const BodyChanges& changes) {
  if (seen_ == 0) {
    watch_.begin(changes);
  } else if (!watch_.see(changes)) {
    seen_ = 0;
    return;
  }
  if (++seen_ < tuning::kUpdatesWatched) return;
  seen_ = 0;
  stays_ = watch_.most_stay() ? stays_ + 1 : 0;
  if (stays_ >= patience_) try_fat_boxes();
}

// Only where bodies move as much as in a world that may do without.
void FatBoxChoice::note(const FatBoxWork& work) {
  if (!may_go_without_ || !much_motion_) return;
  if (pause_ > 0) {
    --pause_;
    return;
  }
  const std::int64_t anew = cost_anew(work);
  const bool pairs_change = work.changed_pairs > work.pairs / tuning::kPairsOfChanged;
  const double least = static_cast<double>(least_cost(work.bodies, work.candidates));
  if (settled_ > 0 && pairs_change && least > tuning::kMostOfAnew * static_cast<double>(anew))
    return go_without();
  if (work.is_full && settled_ < updates_of_settling(work)) {
    ++settled_;
    return;
  }
  settled_ = tuning::kUpdatesOfSettling;
  const std::int64_t most_excess = is_small_ ? tuning::kMostExcess : tuning::kMostExcessOfLarge;
  excess_ += cost_of_fat_boxes(work) - anew;
  if (++judged_ == tuning::kUpdatesJudged || excess_ > most_excess * anew) judge();
}

// In a large world candidates count where all were found: what lasts may have many, until it is refitted.
std::int64_t FatBoxChoice::cost_of_fat_boxes(const FatBoxWork& work) const {
  const std::size_t candidates = is_small_ || work.is_full ? work.candidates : 0;
  return least_cost(work.bodies, candidates) + static_cast<std::int64_t>(cost_of_placing(work));
}

std::uint64_t FatBoxChoice::cost_of_placing(const FatBoxWork& work) const {
  if (work.is_full) return tuning::kAllPlacedCost * work.bodies;
  if (!is_swept_) return tuning::kPlacedCost * work.placed;
  const std::uint64_t partners = 2 * work.placed * work.candidates / work.bodies;
  return tuning::kPlacedInSweptCost * work.placed + tuning::kComparedCost * work.compared +
         tuning::kPartnerCost * partners;
}

std::int64_t FatBoxChoice::cost_anew(const FatBoxWork& work) const {
  const std::uint64_t of_body = is_swept_ ? tuning::kSweptCost : tuning::kAnewCost;
  return static_cast<std::int64_t>(of_body * work.bodies + tuning::kAnewPairCost * work.pairs);
}

void FatBoxChoice::judge() {
  if (excess_ > 0) return go_without();
  if (++lasted_ == tuning::kMostPatienceOfSweeps) {
    lasted_ = 0;
    patience_ = 1;
  }
  judged_ = 0;
  excess_ = 0;
}

// Fat boxes are tried less soon again.
void FatBoxChoice::go_without() {
  is_without_ = true;
  judged_ = 0;
  excess_ = 0;
  lasted_ = 0;
  patience_ = std::min(2 * patience_, tuning::kMostPatienceOfSweeps);
}

}  // namespace cellsweep::stream
