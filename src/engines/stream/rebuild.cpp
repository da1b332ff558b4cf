#include "engines/stream/rebuild.h"

#include <algorithm>
#include <chrono>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

bool may_prepare(const BodyChanges& changes) {
  return changes.inserted.empty() && changes.removed.empty() && do_most_move(changes);
}

}  // namespace

// What is prepared before its time is of no use: bodies are not in their next fat boxes yet.
bool Rebuild::begin_update(const BodyChanges& changes) {
  started_ = Cost::Clock::now();
  ++age_;
  if (holds_memory_ && (!may_prepare(changes) || !watch_.see(changes))) drop();
  if (stage_ != kAll || age_ < begun_ + lasts_) return false;
  may_begin_ = !watch_.most_stay() && fat_boxes_.are_being_left(changes, static_cast<float>(lasts_));
  fat_boxes_.use_prepared();
  return true;
}

std::size_t Rebuild::go_on(const BodyChanges& changes, std::size_t escaped, const Cost& cost) {
  escaped_ += escaped;
  const Cost::Clock::duration besides = Cost::Clock::now() - started_;
  if (!may_begin_ || !may_prepare(changes)) return 0;
  if (stage_ == kNothing && !begin(changes)) return 0;
  const std::uint32_t part = age_ - begun_;
  pace_.note(part, std::chrono::duration<double>(besides).count());
  if (stage_ == kAll) return 0;
  crew_.plan(changes.bodies / (lasts_ - 1), cost.seconds());
  const double before = fat_done_;
  try {
    prepare_until(pace_.due(part), changes);
  } catch (const TooManyPairs&) {
    drop();
    return 0;
  }
  return static_cast<std::size_t>((fat_done_ - before) * static_cast<double>(changes.moved.size()));
}

// At once, or, while fat boxes last, at every look.
bool Rebuild::begin(const BodyChanges& changes) {
  if (age_ % tuning::kAllAhead != 1 || !search_.has_cells()) return false;
  begun_ = age_ - 1;
  lasts_ = updates_for_next(changes);
  if (lasts_ == 0) return false;
  watch_.begin(changes);
  pace_.begin(lasts_ - 1, shares_.seconds());
  shares_.begin(lasts_ - 1);
  fat_boxes_.begin_prepared(changes.boxes);
  holds_memory_ = true;
  stage_ = kBegun;
  return true;
}

// Where bodies creep, so that most stay in their fat boxes for long, half of that time: then that is not
// known so well. 0: for longer than anybody looks ahead.
std::uint32_t Rebuild::updates_for_next(const BodyChanges& changes) const {
  const auto are_left_in = [&](std::uint32_t updates) {
    return fat_boxes_.are_being_left(changes, static_cast<float>(updates));
  };
  if (are_left_in(tuning::kAllAhead)) return made_for_;
  std::uint32_t updates = tuning::kAllAhead;
  for (; updates <= tuning::kMostForNext; updates *= 2)
    if (are_left_in(2 * updates)) return updates;
  return 0;
}

/// Does a part of a stage, and notes what it took.
template <class Work>
void Rebuild::do_part(RebuildStage stage, const Work& work) {
  const Cost::Clock::time_point start = Cost::Clock::now();
  work();
  shares_.note(stage, std::chrono::duration<double>(Cost::Clock::now() - start).count());
}

void Rebuild::prepare_until(double due, const BodyChanges& changes) {
  if (stage_ == kBegun && prepare_fat_boxes(due, changes)) stage_ = kFatBoxes;
  const auto fat = fat_boxes_.prepared();
  const Boxes boxes(fat.data(), fat.size());
  if (stage_ == kFatBoxes && shares_.is_due(kListed, due)) {
    do_part(kListed, [&] {
      overlaps_.put_in_order();  // what was found goes
      search_.begin_prepared(boxes);
    });
    stage_ = kListed;
  }
  if (stage_ == kListed && shares_.is_due(kFilled, due)) {
    do_part(kFilled, [&] { search_.prepared().fill_cells(boxes); });
    copies_ = search_.prepared().copies();
    built_ = 0;
    stage_ = kFilled;
  }
  if (stage_ == kFilled && prepare_cells(due)) stage_ = kCells;
  if (stage_ == kCells && shares_.is_due(kCounted, due)) {
    do_part(kCounted, [&] { overlaps_.prepare(search_.prepared().found()); });
    stage_ = kCounted;
  }
  if (stage_ == kCounted && prepare_order(due)) {
    shares_.learn();
    stage_ = kAll;
  }
}

// True when all of them are made. They will be used when all parts are done, and half an update sooner and
// later, for a body does not keep its course to the last bit. Bodies are mostly listed in the same order each
// time; one that is missed keeps the fat box that it has.
bool Rebuild::prepare_fat_boxes(double due, const BodyChanges& changes) {
  const auto place_of = [&](double share) {
    return static_cast<std::size_t>(share * static_cast<double>(changes.moved.size()));
  };
  const double share = shares_.due_of(kFatBoxes, due);
  const auto ahead = static_cast<float>(begun_ + lasts_ - age_) - 0.5F;
  do_part(kFatBoxes, [&] {
    fat_boxes_.prepare(crew_, changes, {place_of(fat_done_), place_of(share)}, ahead,
                       static_cast<float>(next_lasts_));
  });
  fat_done_ = share;
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
  were_prepared_ = true;
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
  were_prepared_ = false;
  patience_ = 1;
  calm_ = 0;
  begin_anew();
}

void Rebuild::begin_anew() {
  stage_ = kNothing;
  fat_done_ = 0;
  age_ = 0;
  escaped_ = 0;
}

void Rebuild::drop() {
  fat_boxes_.drop_prepared();
  search_.drop_prepared();
  overlaps_.drop_prepared();
  stage_ = kNothing;
  fat_done_ = 0;
  holds_memory_ = false;
}

}  // namespace cellsweep::stream
