#include "engines/stream/stream.h"

#include <algorithm>
#include <cfloat>
#include <chrono>
#include <utility>

#include "base/text.h"
#include "base/tuning.h"
#include "engines/stream/cells/cell_bounds.h"

namespace cellsweep::stream {
namespace {

constexpr std::size_t kAnyNumber = ~std::size_t{0};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Status too_many_pairs(std::size_t most) {
  return Status::over_capacity(
      text("There are more than ", most, " pairs, the most that max_pairs allows; raise it, or set it to 0."),
      most + 1, most, "max_pairs");
}

}  // namespace

// One late thread must not change a plan.
void Stream::Cost::learn(double sample) {
  seconds += 0.25 * (std::clamp(sample, seconds / 4, seconds * 2) - seconds);
}

Stream::Stream(StreamParts parts)
    : parts_(std::move(parts)),
      crew_(*parts_.crew),
      fat_boxes_(parts_.margin),
      cells_(crew_, *parts_.kernels, parts_.finder.get()),
      full_cost_{tuning::kFullGuess},
      partial_cost_{tuning::kPartialGuess} {
  if (parts_.max_pairs == 0) parts_.max_pairs = kAnyNumber;
}

Capacity Stream::capacity() const {
  return {kSlotMask, "", text("a slot's number has ", kSlotBits, " bits")};
}

Stream::Kind Stream::take(const BodyChanges& changes) {
  bodies_ = changes.bodies;
  crew_.plan(changes.moved.size(), tuning::kMoveGuess);
  switch (fat_boxes_.take(crew_, changes, most_listed_)) {
    case FatBoxes::Extent::inside:
      return kInPlace;
    case FatBoxes::Extent::listed:
      return kPartial;
    default:
      return kFull;
  }
}

Result<FoundPairs> Stream::update(const BodyChanges& changes, Statistics& statistics) {
  if (parts_.finder) parts_.finder->begin_update();
  if (changes.none()) {
    note_idle(statistics);
    return FoundPairs{};
  }
  PhaseTimer timer(statistics.phases);
  Kind kind = take(changes);
  timer.lap("fat boxes");
  FoundPairs found;
  try {
    found = counted(find(changes, kind, timer));
  } catch (const TooManyPairs&) {
    return too_many_pairs(parts_.max_pairs);
  } catch (PieceFailure& failure) {
    return std::move(failure.status);
  }
  plan_ahead();
  was_full_ = kind == kFull;
  ++updates_[kind];
  refresh_counters(statistics);
  return found;
}

StreamView Stream::view(std::span<const Aabb> boxes) const {
  StreamView view;
  Aabb bounds{{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
  const Aabb* fat = fat_boxes_.data(boxes);
  for (std::size_t slot = 0; slot < boxes.size(); ++slot) {
    if (!(fat[slot].min[0] <= fat[slot].max[0])) continue;  // nobody
    view.fat_boxes.push_back(fat[slot]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.min[axis] = std::min(bounds.min[axis], fat[slot].min[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], fat[slot].max[axis]);
    }
  }
  list_cell_bounds(cells_.root(), bounds, view.cells);
  return view;
}

void Stream::note_idle(Statistics& statistics) {
  ++updates_[kIdle];
  was_full_ = false;
  statistics.phases.clear();
  if (statistics.counters.empty()) return refresh_counters(statistics);
  statistics.bytes += bytes_;
  statistics.counters[kIdle].value = updates_[kIdle];
}

FoundPairs Stream::counted(const FoundPairs& found) {
  pairs_ = pairs_ + found.began.size() + count_keys(found.more_began) - found.ended.size();
  if (pairs_ > parts_.max_pairs) throw TooManyPairs();
  return found;
}

FoundPairs Stream::find(const BodyChanges& changes, Kind& kind, PhaseTimer& timer) {
  if (bodies_ == 0) return find_none(changes);
  if (candidates_are_pairs_ && fat_boxes_.have_slack() && kind != kFull) {
    candidates_are_pairs_ = false;
    marks_say_ = Marks::all_are_pairs;
  }
  if (kind != kFull && have_cells_ && are_few(changes)) return find_of_few(changes, timer);
  if (kind == kInPlace) return test_candidates(changes, {}, timer);
  const Clock::time_point start = Clock::now();
  const bool with_cells = wants_cells(kind);
  if (kind == kPartial && have_cells_ && change_cells()) return find_changed(changes, start, timer);
  kind = kFull;
  return find_all(changes, with_cells, start, timer);
}

// A small world is swept when all is new, and while it is so in every update. Else cells will be asked for
// the bodies that leave their fat boxes.
bool Stream::wants_cells(Kind kind) const {
  return kind == kPartial || (fat_boxes_.have_slack() && !was_full_);
}

// Too many candidates among the few that changed are no reason to refuse: all of them may have become too
// large. False when everything is to be found anew.
bool Stream::change_cells() {
  crew_.plan(fat_boxes_.changes().size(), partial_cost_.seconds);
  try {
    cells_.change(fat_boxes_.changes());
  } catch (const TooManyPairs&) {
    return false;
  }
  return true;
}

FoundPairs Stream::find_changed(const BodyChanges& changes, Clock::time_point start, PhaseTimer& timer) {
  repair_marks(changes);
  timer.lap("cells");
  const auto count = static_cast<double>(fat_boxes_.changes().size());
  changed_ += fat_boxes_.changes().size();
  const SlotPairChanges of_candidates = candidates_.change(crew_, cells_.began(), cells_.ended());
  timer.lap("sort");
  partial_cost_.learn(seconds_since(start) * crew_.active() / count);
  if (candidates_are_pairs_) return {.began = of_candidates.began, .ended = of_candidates.ended};
  return test_candidates(changes, of_candidates, timer);
}

// With nobody left, everything ends, and the memory goes back.
FoundPairs Stream::find_none(const BodyChanges& changes) {
  list_pairs_before(changes);
  fat_boxes_ = FatBoxes(parts_.margin);
  cells_.clear();
  have_cells_ = false;
  sweep_ = {};
  swept_ = {};
  candidates_ = {};
  marks_ = {};
  now_ = {};
  began_ = {};
  ended_ = {};
  fresh_ = Vector<std::uint8_t>();
  few_ = {};
  candidates_are_pairs_ = true;
  marks_say_ = Marks::true_of_it;
  return {.ended = std::as_const(before_).view()};
}

FoundPairs Stream::find_all(const BodyChanges& changes, bool with_cells, Clock::time_point start,
                            PhaseTimer& timer) {
  list_pairs_before(changes);
  crew_.plan(bodies_, full_cost_.seconds);
  find_candidates(changes, with_cells);
  built_copies_ = cells_.copies();
  changed_ += bodies_;
  timer.lap("cells");
  const KeyParts found = have_cells_ ? cells_.found() : KeyParts{&swept_view_, 1};
  candidates_.replace(found);
  candidates_are_pairs_ = !fat_boxes_.have_slack();
  // The first pairs of all need not be in order here, when they will be sorted by ids.
  const bool in_order = !candidates_are_pairs_ || pairs_ > 0 || changes.ids_ascend;
  if (in_order) {
    candidates_.pairs(crew_);
    timer.lap("sort");
  }
  full_cost_.learn(seconds_since(start) * crew_.active() / static_cast<double>(bodies_));
  if (!in_order) return {.more_began = found};
  return candidates_are_pairs_ ? compare_with_before(candidates_.pairs(crew_)) : test_all(changes, timer);
}

FoundPairs Stream::test_all(const BodyChanges& changes, PhaseTimer& timer) {
  const std::span<const SlotPair> candidates = candidates_.pairs(crew_);
  crew_.plan(candidates.size(), tuning::kTestGuess);
  marks_.test_all(crew_, candidates, changes.boxes.data());
  tested_ += candidates.size();
  marks_say_ = Marks::true_of_it;
  marks_.list_marked(candidates, now_);
  const FoundPairs found = compare_with_before(std::as_const(now_).view());
  timer.lap("tests");
  return found;
}

// What the candidates are about to be replaced by says nothing about them.
void Stream::list_pairs_before(const BodyChanges& changes) {
  repair_marks(changes);
  const std::span<const SlotPair> candidates = candidates_.pairs(crew_);
  if (!candidates_are_pairs_) return marks_.list_marked(candidates, before_);
  before_.renew(candidates.size());
  std::copy(candidates.begin(), candidates.end(), before_.data());
}

FoundPairs Stream::compare_with_before(std::span<const SlotPair> now) {
  if (before_.size() == 0) return {.began = now};
  find_changes<SlotPair>(before_.view(), now, {}, began_, ended_);
  return {.began = std::as_const(began_).view(), .ended = std::as_const(ended_).view()};
}

// Where marks were not kept up to date, they are what the boxes of the last update say.
void Stream::repair_marks(const BodyChanges& changes) {
  if (marks_say_ == Marks::true_of_it) return;
  const std::span<const SlotPair> candidates = candidates_.pairs(crew_);
  if (marks_say_ == Marks::all_are_pairs) {
    marks_.mark_all(candidates.size());
    marks_say_ = Marks::true_of_it;
    return;
  }
  crew_.plan(candidates.size(), tuning::kTestGuess);
  mark_fresh(changes, 1);
  marks_.test_all(crew_, candidates, BoxesBefore{changes.boxes.data(), changes.before.data(), fresh_.data()});
  mark_fresh(changes, 0);
  tested_ += candidates.size();
  marks_say_ = Marks::true_of_it;
}

bool Stream::are_few(const BodyChanges& changes) const {
  const std::size_t count = changes.moved.size() + changes.inserted.size() + changes.removed.size();
  return count * tuning::kCandidatesOfQuery < candidates_.size();
}

FoundPairs Stream::find_of_few(const BodyChanges& changes, PhaseTimer& timer) {
  mark_fresh(changes, 1);
  few_.ask_before(cells_, changes, fresh_.data());
  for (const FatBoxChange& change : fat_boxes_.changes()) {
    cells_.change_one(change);
    candidates_.note(crew_, cells_.began(), cells_.ended());
  }
  changed_ += fat_boxes_.changes().size();
  timer.lap("cells");
  few_.ask_now(cells_, changes, fresh_.data());
  mark_fresh(changes, 0);
  if (!candidates_are_pairs_) marks_say_ = Marks::stale;
  const SlotPairChanges found = few_.changes(crew_);
  timer.lap("tests");
  return {.began = found.began, .ended = found.ended};
}

std::size_t Stream::generous_limit() const {
  return parts_.max_pairs < kAnyNumber / 4 ? 2 * parts_.max_pairs + tuning::kFewCandidates : kAnyNumber;
}

// Fat boxes that overlap are no reason to refuse, but when there are very many, boxes are put in their place.
void Stream::find_candidates(const BodyChanges& changes, bool with_cells) {
  if (fat_boxes_.have_slack()) {
    try {
      return find_among({fat_boxes_.data(changes.boxes), changes.boxes.size()}, generous_limit(), with_cells);
    } catch (const TooManyPairs&) {
      fat_boxes_.drop_slack();
    }
  }
  find_among(changes.boxes, parts_.max_pairs, with_cells);
  cells_.limit_pairs(generous_limit());
}

void Stream::find_among(std::span<const Aabb> boxes, std::size_t most, bool with_cells) {
  have_cells_ = with_cells || !sweep(boxes, most);
  if (!have_cells_) return cells_.clear();
  cells_.limit_pairs(most);
  cells_.build({boxes.data(), boxes.size()});
}

// False when the world is not a small one, or cells take less.
bool Stream::sweep(std::span<const Aabb> boxes, std::size_t most) {
  if (parts_.finder || parts_.kernels->sweep == nullptr || boxes.size() > tuning::kMostSwept) return false;
  swept_.clear();
  swept_.buffer().most = most;
  if (!sweep_.find(*parts_.kernels, boxes, swept_)) return false;
  swept_view_ = swept_.view();
  return true;
}

FoundPairs Stream::test_candidates(const BodyChanges& changes, const SlotPairChanges& of_candidates,
                                   PhaseTimer& timer) {
  repair_marks(changes);
  const SlotPairChanges found = refresh_marks(changes, of_candidates);
  timer.lap("tests");
  return {.began = found.began, .ended = found.ended};
}

SlotPairChanges Stream::refresh_marks(const BodyChanges& changes, const SlotPairChanges& of_candidates) {
  const std::span<const SlotPair> candidates = candidates_.pairs(crew_);
  crew_.plan(candidates.size(), tuning::kTestGuess);
  tested_ += candidates.size();
  const bool few = changes.moved.size() + changes.inserted.size() < bodies_ / tuning::kFewFresh;
  if (!few) return marks_.refresh(crew_, candidates, of_candidates, {changes.boxes.data()});
  mark_fresh(changes, 1);
  const SlotPairChanges found =
      marks_.refresh(crew_, candidates, of_candidates, {changes.boxes.data(), fresh_.data()});
  mark_fresh(changes, 0);
  return found;
}

void Stream::mark_fresh(const BodyChanges& changes, std::uint8_t mark) {
  make_room(fresh_, changes.boxes.size());
  fresh_.resize(changes.boxes.size(), 0);
  for (const Slot slot : changes.removed) fresh_[slot] = mark;
  for (const Slot slot : changes.moved) fresh_[slot] = mark;
  for (const Slot slot : changes.inserted) fresh_[slot] = mark;
}

// Up to how many changes the next update would rather look at one by one. Cells wear out: boxes that enter
// leave gaps in memory behind and crowd cells.
void Stream::plan_ahead() {
  const double count = static_cast<double>(bodies_);
  const bool worn_out = cells_.copies() > 2 * built_copies_ + 1024;
  const double most =
      count * std::clamp(full_cost_.seconds / partial_cost_.seconds, tuning::kLeastShare, tuning::kMostShare);
  most_listed_ = worn_out || parts_.finder ? 0 : static_cast<std::size_t>(most);
}

void Stream::refresh_counters(Statistics& statistics) {
  bytes_ = fat_boxes_.bytes() + cells_.bytes() + candidates_.bytes() + marks_.bytes() + before_.bytes() +
           now_.bytes() + began_.bytes() + ended_.bytes() + fresh_.capacity() + few_.bytes() +
           sweep_.bytes() + swept_.bytes();
  statistics.bytes += bytes_;
  statistics.counters.assign({{"full updates", updates_[kFull]},
                              {"partial updates", updates_[kPartial]},
                              {"in-place updates", updates_[kInPlace]},
                              {"idle updates", updates_[kIdle]},
                              {"fat boxes put into cells", changed_},
                              {"candidates", candidates_.size()},
                              {"pieces", cells_.pieces()},
                              {"boxes in cells", cells_.copies()},
                              {"boxes compared", cells_.tests() + sweep_.tests() + tested_},
                              {"workers", crew_.active()},
                              {"vector lanes", parts_.kernels->lanes}});
  if (parts_.finder) parts_.finder->add_counters(statistics.counters);
}

}  // namespace cellsweep::stream
