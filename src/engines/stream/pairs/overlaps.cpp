#include "engines/stream/pairs/overlaps.h"

#include <utility>

#include "base/pairs/pair_changes.h"
#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

bool do_few_change(const BodyChanges& changes) {
  return changes.moved.size() + changes.inserted.size() < changes.bodies / tuning::kFewFresh;
}

}  // namespace

void Overlaps::set_aside(const BodyChanges& changes) {
  reunite();
  const bool are_marked = marks_say_ != Marks::all_overlap;
  if (are_marked) repair_marks(changes);
  list_.take(crew_, room_, before_);
  if (are_marked) marks_.leave_marked(before_);
  marks_say_ = Marks::true_of_it;
}

void Overlaps::replace(KeyParts found, bool are_pairs) {
  list_.replace(found);
  are_pairs_ = are_pairs;
}

bool Overlaps::are_in_order(const BodyChanges& changes) const {
  return !are_pairs_ || before_.size() > 0 || changes.ids_ascend;
}

FoundPairs Overlaps::compare(const BodyChanges& changes) {
  marks_say_ = are_pairs_ ? Marks::all_overlap : Marks::true_of_it;
  if (!are_in_order(changes)) return {.more_began = list_.found()};
  const std::span<const SlotPair> now = list_.pairs(crew_, room_);
  const std::span<const SlotPair> before = std::as_const(before_).view();
  before_.shrink(0);
  if (are_pairs_ && before.empty()) return {.began = now};
  if (are_pairs_) {
    find_changes<SlotPair>(before, now, {}, room_.one, room_.other);
    return {.began = std::as_const(room_.one).view(), .ended = std::as_const(room_.other).view()};
  }
  {
    const TimedWork work(crew_, now.size(), test_cost_);
    marks_.test_all(crew_, now, changes.boxes.data());
  }
  tests_ += now.size();
  const SlotPairChanges found = marks_.compare(before, now, room_);
  return {.began = found.began, .ended = found.ended};
}

// Where marks were not kept up to date, they are what the boxes of the last update say.
void Overlaps::repair_marks(const BodyChanges& changes) {
  if (marks_say_ == Marks::true_of_it) return;
  const std::span<const SlotPair> candidates = list_.pairs(crew_, room_);
  if (marks_say_ == Marks::all_overlap) {
    marks_.mark_all(candidates.size());
  } else {
    const TimedWork work(crew_, candidates.size(), test_cost_);
    mark_fresh(changes, 1);
    marks_.test_all(crew_, candidates, {changes.boxes.data(), changes.before, fresh_.data()});
    mark_fresh(changes, 0);
    tests_ += candidates.size();
  }
  marks_say_ = Marks::true_of_it;
}

// What is parted has marks that are true.
void Overlaps::begin_walk(const BodyChanges& changes) {
  if (!do_few_change(changes) || are_pairs_) return reunite();
  if (resting_.begin_update(changes)) reunite();
  if (!resting_.are_known() || marks_say_ != Marks::true_of_it) return;
  resting_.part({list_.all(crew_, room_), marks_.all()});
  list_.note_change();
}

void Overlaps::reunite() {
  if (!resting_.are_parted()) return;
  resting_.reunite({list_.all(crew_, room_), marks_.all()});
  list_.note_change();
}

SlotPairChanges Overlaps::change_candidates(const BodyChanges& changes,
                                            std::span<const FatBoxChange> fat_changes,
                                            const CellTree& cells) {
  if (!are_pairs_) repair_marks(changes);
  make_room_for_few(changes);
  mark_fresh(fat_changes, 1);
  const SlotPairChanges found = list_.change(crew_, room_, cells.touched(), fresh_.data());
  mark_fresh(fat_changes, 0);
  return found;
}

bool Overlaps::change_prepared(const BodyChanges& changes, std::span<const FatBoxChange> fat_changes,
                               CellTree& cells) {
  make_room_for_few(changes);
  mark_fresh(fat_changes, 1);
  bool is_done = true;
  try {
    cells.change_found(fat_changes, fresh_.data());
  } catch (const TooManyPairs&) {
    is_done = false;
  } catch (const TooMuchWork&) {
    is_done = false;
  }
  mark_fresh(fat_changes, 0);
  return is_done;
}

FoundPairs Overlaps::test(const BodyChanges& changes, const SlotPairChanges& of_candidates) {
  if (are_pairs_) return {.began = of_candidates.began, .ended = of_candidates.ended};
  repair_marks(changes);
  const std::span<const SlotPair> candidates = list_.pairs(crew_, room_);
  const TimedWork work(crew_, candidates.size(), test_cost_);
  tests_ += candidates.size();
  const bool few = do_few_change(changes);
  if (few) mark_fresh(changes, 1);
  const SlotPairChanges found = marks_.refresh(crew_, candidates, of_candidates,
                                               {changes.boxes.data(), few ? fresh_.data() : nullptr}, room_);
  if (few) mark_fresh(changes, 0);
  return {.began = found.began, .ended = found.ended};
}

bool Overlaps::choose_few(const BodyChanges& changes) {
  const std::size_t changed = changes.moved.size() + changes.inserted.size() + changes.removed.size();
  return few_choice_.choose_few(changed, list_.size(), marks_say_ == Marks::stale || list_.waits());
}

void Overlaps::change_cells_of_few(CellTree& cells, const BodyChanges& changes,
                                   std::span<const FatBoxChange> fat_changes) {
  reunite();
  list_.begin_notes(crew_, room_);
  cells.begin_changes();
  mark_fresh(changes, PairsOfFew::kChanged);
  few_.begin(changes, fresh_.data());
  for (const FatBoxChange& change : fat_changes) {
    if (change.was) note(few_.had(cells, change.slot, change.old_box), false);
    cells.change_one(change);
    if (change.is) note(few_.has(cells, change.slot, change.new_box), true);
    fresh_[change.slot] = PairsOfFew::kAsked;
  }
}

void Overlaps::note(std::span<const std::uint64_t> keys, bool are_there) {
  if (!list_.note(keys, are_there)) throw TooMuchWork();
}

void Overlaps::forget_few(const BodyChanges& changes) {
  list_.forget_notes();
  mark_fresh(changes, PairsOfFew::kUnchanged);
}

FoundPairs Overlaps::find_of_few(CellTree& cells, const BodyChanges& changes, const FatBoxes& fat_boxes) {
  for (const Slot slot : changes.moved) {
    if (fresh_[slot] == PairsOfFew::kAsked) continue;
    few_.stayed(cells, slot, fat_boxes[slot]);
    fresh_[slot] = PairsOfFew::kAsked;
  }
  mark_fresh(changes, PairsOfFew::kUnchanged);
  if (!are_pairs_) marks_say_ = Marks::stale;
  const SlotPairChanges found = few_.changes(crew_);
  return {.began = found.began, .ended = found.ended};
}

FoundPairs Overlaps::end_all(const BodyChanges& changes) {
  set_aside(changes);
  std::swap(before_, ended_);
  clear();
  return {.ended = std::as_const(ended_).view()};
}

void Overlaps::clear() {
  list_ = {};
  marks_ = {};
  few_ = {};
  few_choice_ = {};
  resting_ = {};
  fresh_ = {};
  room_ = {};
  before_ = {};
  are_pairs_ = true;
  marks_say_ = Marks::all_overlap;
}

void Overlaps::give_back() {
  list_.give_back(crew_);
  marks_.give_back();
  few_ = {};
  room_ = {};
  before_ = {};
  ended_ = {};
}

void Overlaps::mark_fresh(const BodyChanges& changes, std::uint8_t mark) {
  make_room_for_few(changes);
  for (const Slot slot : changes.removed) fresh_[slot] = mark;
  for (const Slot slot : changes.moved) fresh_[slot] = mark;
  for (const Slot slot : changes.inserted) fresh_[slot] = mark;
}

void Overlaps::mark_fresh(std::span<const FatBoxChange> fat_changes, std::uint8_t mark) {
  for (const FatBoxChange& change : fat_changes) fresh_[change.slot] = mark;
}

void Overlaps::make_room_for_few(const BodyChanges& changes) {
  fresh_.resize(changes.boxes.size(), 0);
}

std::size_t Overlaps::bytes() const {
  return list_.bytes() + prepared_.bytes() + marks_.bytes() + resting_.bytes() + few_.bytes() +
         room_.bytes() + before_.bytes() + ended_.bytes() + fresh_.bytes();
}

}  // namespace cellsweep::stream
