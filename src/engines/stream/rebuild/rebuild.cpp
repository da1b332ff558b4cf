#include "engines/stream/rebuild/rebuild.h"

#include <algorithm>
#include <chrono>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// The places of moved bodies from one share of them, 0 to 1, to another one.
Share places_of(const BodyChanges& changes, double from, double to) {
  const auto place_of = [&](double share) {
    return static_cast<std::size_t>(share * static_cast<double>(changes.moved.size()));
  };
  return {place_of(from), place_of(to)};
}

bool may_prepare(const BodyChanges& changes) {
  return changes.inserted.empty() && changes.removed.empty() && do_most_move(changes);
}

}  // namespace

// What is prepared before its time is of no use: bodies are not in their next fat boxes yet.
bool Rebuild::begin_update(const BodyChanges& changes, WorkCost::Clock::time_point now) {
  started_ = now;
  ++age_;
  if (holds_memory_ && (!may_prepare(changes) || !watch_.see(changes))) drop();
  if (stage_ != kAll || age_ < used_at_) return false;
  may_begin_ = !watch_.most_stay() && fat_boxes_.are_being_left(changes, static_cast<float>(lasts_));
  fat_boxes_.use_prepared();
  return true;
}

std::size_t Rebuild::go_on(const BodyChanges& changes, std::size_t escaped) {
  escaped_ += escaped;
  if (!may_begin_ || !may_prepare(changes)) return 0;
  if (stage_ == kNothing && !begin(changes)) return 0;
  const WorkCost::Clock::duration besides = WorkCost::Clock::now() - started_;
  const std::uint32_t part = age_ - first_part_ + 1;
  pace_.note(part, std::chrono::duration<double>(besides).count());
  if (stage_ == kAll) return 0;
  crew_.use(workers_);
  placed_ = 0;
  try {
    prepare_until(pace_.due(part), changes);
  } catch (const TooManyPairs&) {
    drop();
    return 0;
  }
  return placed_;
}

// At once, in the update that put those in use in their place or found everything anew, or in the next one;
// or, while fat boxes last, at every look.
bool Rebuild::begin(const BodyChanges& changes) {
  if ((age_ > 1 && age_ % tuning::kAllAhead != 0) || !search_.has_cells()) return false;
  lasts_ = updates_for_next(changes);
  if (lasts_ == 0) return false;
  first_part_ = age_;
  used_at_ = std::max(age_, 1U) - 1 + lasts_;
  watch_.begin(changes);
  pace_.begin(parts(), shares_.seconds());
  shares_.begin(parts());
  crew_.plan(changes.bodies / parts(), cost_);
  workers_ = crew_.active();
  fat_boxes_.begin_prepared(changes.boxes);
  holds_memory_ = true;
  go_to(kBegun);
  return true;
}

// Where bodies creep, so that most stay in their fat boxes for long, half of that time: then that is not
// known so well. 0: for longer than anybody looks ahead, which is asked first: bodies that tremble at rest
// are looked at again and again.
std::uint32_t Rebuild::updates_for_next(const BodyChanges& changes) const {
  const auto are_left_in = [&](std::uint32_t updates) {
    return fat_boxes_.are_being_left(changes, static_cast<float>(updates));
  };
  if (!are_left_in(2 * tuning::kMostForNext)) return 0;
  if (are_left_in(tuning::kAllAhead)) return made_for_;
  std::uint32_t updates = tuning::kAllAhead;
  while (updates < tuning::kMostForNext && !are_left_in(2 * updates)) updates *= 2;
  return updates;
}

/// Does a part of a stage, and notes what it took.
template <class Work>
void Rebuild::do_part(RebuildStage stage, const Work& work) {
  const WorkCost::Clock::time_point start = WorkCost::Clock::now();
  work();
  shares_.note(stage, std::chrono::duration<double>(WorkCost::Clock::now() - start).count());
}

void Rebuild::go_to(RebuildStage stage) {
  stage_ = stage;
  stage_done_ = 0;
}

void Rebuild::prepare_until(double due, const BodyChanges& changes) {
  if (stage_ == kBegun && prepare_fat_boxes(due, changes)) go_to(kFatBoxes);
  const auto fat = fat_boxes_.prepared();
  const Boxes boxes(fat.data(), fat.size());
  if (stage_ == kFatBoxes && shares_.is_due(kListed, due)) {
    do_part(kListed, [&] {
      overlaps_.put_in_order();  // what was found goes
      search_.begin_prepared(boxes);
    });
    go_to(kListed);
  }
  if (stage_ == kListed && fill_cells(due, boxes)) go_to(kFilled);
  if (stage_ == kFilled && prepare_cells(due)) go_to(kCells);
  if (stage_ == kCells && mend_fat_boxes(due, changes)) go_to(kMended);
  if (stage_ == kMended && shares_.is_due(kCounted, due)) {
    do_part(kCounted, [&] { overlaps_.prepare(search_.prepared().found()); });
    go_to(kCounted);
  }
  if (stage_ == kCounted && prepare_order(due)) {
    cost_.learn(std::chrono::duration<double>(shares_.learn()), workers_, changes.bodies);
    go_to(kAll);
  }
}

// True when all of them are made. Bodies are mostly listed in the same order each time; one that is missed
// keeps the fat box that it has.
bool Rebuild::prepare_fat_boxes(double due, const BodyChanges& changes) {
  const double share = shares_.due_of(kFatBoxes, due);
  const Share places = places_of(changes, stage_done_, share);
  do_part(kFatBoxes, [&] {
    fat_boxes_.prepare(crew_, changes, places, updates_left(), static_cast<float>(next_lasts_));
  });
  placed_ += places.last - places.first;
  stage_done_ = share;
  return share == 1;
}

// True when all were looked at. Some bodies have turned since theirs were made: the next update has no time
// to make all of these anew.
bool Rebuild::mend_fat_boxes(double due, const BodyChanges& changes) {
  const double share = shares_.due_of(kMended, due);
  const Share places = places_of(changes, stage_done_, share);
  bool is_done = true;
  do_part(kMended, [&] {
    const std::span<const FatBoxChange> mended =
        fat_boxes_.mend_prepared(crew_, changes, places, updates_left(), static_cast<float>(next_lasts_));
    placed_ += mended.size();
    is_done = mended.empty() || overlaps_.change_prepared(changes, mended, search_.prepared());
  });
  if (!is_done) throw TooManyPairs();
  stage_done_ = share;
  return share == 1;
}

// True when all boxes are there.
bool Rebuild::fill_cells(double due, const Boxes& boxes) {
  const double share = shares_.due_of(kFilled, due);
  do_part(kFilled, [&] { search_.prepared().fill_cells(boxes, share); });
  copies_ = search_.prepared().copies();
  built_ = 0;
  return share == 1;
}

// True when all of them are made.
bool Rebuild::prepare_cells(double due) {
  const auto wanted = static_cast<std::uint64_t>(shares_.due_of(kCells, due) * static_cast<double>(copies_));
  CellTree& cells = search_.prepared();
  if (wanted > built_) do_part(kCells, [&] { built_ += cells.go_on(wanted - built_); });
  return cells.is_built();
}

// True when all candidates are in order, and it is time for them.
bool Rebuild::prepare_order(double due) {
  const double share = shares_.due_of(kAll, due);
  bool is_done = false;
  do_part(kAll, [&] { is_done = overlaps_.sort_prepared(share); });
  return is_done && share == 1;
}

void Rebuild::note_used(std::size_t bodies) {
  made_for_ = next_lasts_;
  calm_ = escaped_ < bodies / tuning::kFewEscaped ? calm_ + 1 : 0;
  if (escaped_ > bodies / tuning::kManyEscaped) {
    next_lasts_ = std::max(next_lasts_ - 1, tuning::kLastsAtLeast);
    patience_ = std::min(2 * patience_, tuning::kMostPatience);
  } else if (calm_ >= patience_) {
    next_lasts_ = std::min(next_lasts_ + 1, tuning::kAllAhead);
    calm_ = 0;
  }
  begin_anew();
}

// Fat boxes that lasted for long will do so again. How long the first will is not known.
void Rebuild::note_full() {
  if (holds_memory_) drop();
  const bool are_first = age_ <= 1;
  may_begin_ = are_first || age_ > tuning::kLastsAtLeast;
  made_for_ = next_lasts_ = are_first ? tuning::kAllAhead : std::min(age_ - 1, tuning::kAllAhead);
  patience_ = 1;
  calm_ = 0;
  begin_anew();
}

void Rebuild::begin_anew() {
  go_to(kNothing);
  age_ = 0;
  escaped_ = 0;
}

void Rebuild::drop() {
  fat_boxes_.drop_prepared();
  search_.drop_prepared();
  overlaps_.drop_prepared();
  go_to(kNothing);
  holds_memory_ = false;
}

}  // namespace cellsweep::stream
