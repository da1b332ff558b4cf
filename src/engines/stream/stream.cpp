#include "engines/stream/stream.h"

#include <new>
#include <utility>

#include "base/text.h"
#include "base/tuning.h"
#include "engines/stream/bodies/watch.h"
#include "engines/stream/cells/cell_bounds.h"
#include "engines/stream/common_options.h"
#include "geometry/bounds.h"

namespace cellsweep::stream {
namespace {

StreamParts with_a_limit(StreamParts parts) {
  if (parts.max_pairs == 0) parts.max_pairs = Search::kAnyNumber;
  return parts;
}

}  // namespace

Stream::Stream(StreamParts parts)
    : parts_(with_a_limit(std::move(parts))),
      crew_(*parts_.crew),
      fat_boxes_(parts_.margin),
      search_(crew_, *parts_.kernels, parts_.finder.get(), parts_.max_pairs),
      overlaps_(crew_),
      rebuild_(crew_, fat_boxes_, search_, overlaps_),
      fat_box_choice_(!parts_.finder && parts_.margin == 0, parts_.kernels->sweep != nullptr) {}

Stream::~Stream() = default;

Capacity Stream::capacity() const {
  return {kSlotMask, "", text("a slot's number has ", kSlotBits, " bits")};
}

Stream::Kind Stream::take(const BodyChanges& changes, WorkCost::Clock::time_point now) {
  bodies_ = changes.bodies;
  search_.allow(changes.filters);
  if (parts_.margin == 0)
    search_.limit_candidates(tuning::kCandidatesOfPair * pairs_ + tuning::kCandidatesOfBody * bodies_);
  is_anew_ = fat_box_choice_.begin_update(crew_, changes);
  if (is_anew_) {
    uses_prepared_ = false;
    if (fat_boxes_.have_slack()) fat_boxes_.drop_slack();
    return kFull;
  }
  fat_boxes_.use_growth(growth_choice_.growth());
  uses_prepared_ = rebuild_.begin_update(changes, now);
  const TimedWork work(crew_, changes.moved.size(), costs_.looked_at);
  if (!uses_prepared_ && refit(changes)) return kFull;
  switch (fat_boxes_.take(crew_, changes, list_limit(changes))) {
    case FatBoxes::Extent::inside:
      return kInPlace;
    case FatBoxes::Extent::listed:
      return kPartial;
    default:
      slack_cost_.note_made();
      return kFull;
  }
}

// Without cells everything is found anew as soon as one has left its fat box. Where the others will have
// soon, all are made anew with it: else that would be done twice.
ListLimit Stream::list_limit(const BodyChanges& changes) const {
  const bool at_once = !search_.has_cells() && do_most_move(changes);
  return {most_listed_, at_once ? tuning::kLeftSoon : 0};
}

// Of bodies that do not move they stay what they are.
bool Stream::refit(const BodyChanges& changes) {
  const std::size_t candidates = overlaps_.candidates();
  if (!do_most_move(changes) || !slack_cost_.is_high(bodies_, candidates)) return false;
  slack_cost_.note_refit(candidates);
  fat_boxes_.refit(crew_, changes);
  return true;
}

void Stream::note_full() {
  rebuild_.note_full();
  if (is_anew_) fat_box_choice_.note_anew(search_.has_cells());
}

void Stream::note_fat_boxes(const BodyChanges& changes, const FatBoxWork& work) {
  fat_box_choice_.note(work);
  growth_choice_.note(work, do_most_move(changes));
}

FatBoxWork Stream::work_of(const BodyChanges& changes, Kind kind) const {
  const bool is_full = kind == kFull;
  return {bodies_,
          is_full,
          fat_boxes_.changes().size(),
          compared_,
          overlaps_.candidates(),
          pairs_,
          changed_pairs_,
          is_full && fat_boxes_.do_most_settle(changes)};
}

Result<FoundPairs> Stream::update(const BodyChanges& changes, Statistics& statistics) {
  if (parts_.finder) parts_.finder->begin_update();
  if (spare_memory_.begin_update()) give_back();
  if (changes.none()) {
    note_idle(statistics);
    return FoundPairs{};
  }
  PhaseTimer timer(statistics.phases);
  Kind kind = take(changes, timer.last());
  timer.lap("fat boxes");
  FoundPairs found;
  try {
    found = counted(find(changes, kind, timer));
    found.is_filtered = true;
    if (kind == kFull) {
      note_full();
    } else if (!parts_.finder) {
      changed_ += rebuild_.go_on(changes, fat_boxes_.changes().size());
      if (rebuild_.is_under_way()) timer.lap("next cells");
    }
  } catch (const TooManyPairs&) {
    forget_all();
    return too_many_pairs(parts_.max_pairs);
  } catch (PieceFailure& failure) {
    forget_all();
    return std::move(failure.status);
  } catch (...) {
    forget_all();
    throw;
  }
  if (!is_anew_) note_fat_boxes(changes, work_of(changes, kind));
  most_listed_ = search_.is_worn_out() || parts_.finder ? 0 : costs_.most_listed(bodies_);
  was_full_ = kind == kFull;
  ++updates_[kind];
  if (spare_memory_.is_to_count(is_of_few_, pairs_)) count_bytes();
  if (statistics.counters.empty()) list_counters(statistics);
  return found;
}

FoundPairs Stream::find(const BodyChanges& changes, Kind& kind, PhaseTimer& timer) {
  is_of_few_ = false;
  compared_ = 0;
  if (bodies_ == 0) return find_none(changes);
  if (fat_boxes_.have_slack()) overlaps_.loosen();
  if (uses_prepared_ && kind != kFull) return find_prepared(changes, kind, timer);
  FoundPairs found;
  bool goes_on = kind != kFull;
  if (goes_on && search_.has_cells() && overlaps_.choose_few(changes)) {
    is_of_few_ = find_of_few(changes, timer, found);
    if (is_of_few_) return found;
    goes_on = false;
  }
  spare_memory_.note_used();
  if (goes_on && kind == kInPlace) return find_in_place(changes, timer);
  if (goes_on && search_.has_cells() && find_changed(changes, timer, found)) return found;
  // A small world is swept when all is new, and while it is so in every update. Else cells will be asked for
  // the bodies that leave their fat boxes.
  const bool with_cells = kind == kPartial || (fat_boxes_.have_slack() && !was_full_);
  const std::size_t most_swept = is_anew_ ? tuning::kMostSweptInMotion : tuning::kMostSwept;
  kind = kFull;
  return find_all(changes, with_cells ? 0 : most_swept, timer);
}

// With nobody left, everything ends, and the memory goes back.
FoundPairs Stream::find_none(const BodyChanges& changes) {
  const FoundPairs found = overlaps_.end_all(changes);
  forget_all();
  return found;
}

// Nor may memory wait for the next update where this one failed: that may be long.
void Stream::forget_all() {
  rebuild_.drop();
  fat_boxes_ = FatBoxes(parts_.margin);
  slack_cost_ = {};
  growth_choice_ = {};
  search_.clear();
  search_.give_back();
  overlaps_.clear();
  spare_memory_.note_given_back();
}

// A list that moves to a smaller place asks for it. Where there is none the update goes on, and what is left
// goes another time.
void Stream::give_back() {
  spare_memory_.note_tried();
  try {
    rebuild_.drop();
    fat_boxes_.give_back();
    overlaps_.give_back();
    search_.give_back();
    spare_memory_.note_given_back();
  } catch (const std::bad_alloc&) {
  }
  count_bytes();
}

void Stream::count_bytes() {
  spare_memory_.count(bytes_held(), most_bytes(), pairs_);
}

std::size_t Stream::most_bytes() const {
  return tuning::kFewBytes * (2 + crew_.workers()) + tuning::kBytesOfBody * bodies_ +
         tuning::kBytesOfCopy * search_.cells().copies() + tuning::kBytesOfCandidate * overlaps_.candidates();
}

// False when everything is to be found anew instead.
bool Stream::find_of_few(const BodyChanges& changes, PhaseTimer& timer, FoundPairs& found) {
  try {
    overlaps_.change_cells_of_few(search_.cells(), changes, fat_boxes_.changes());
    timer.lap("cells");
    found = overlaps_.find_of_few(search_.cells(), changes, fat_boxes_);
  } catch (const TooMuchWork&) {
    overlaps_.forget_few(changes);
    return false;
  }
  changed_ += fat_boxes_.changes().size();
  timer.lap("tests");
  return true;
}

FoundPairs Stream::find_in_place(const BodyChanges& changes, PhaseTimer& timer) {
  overlaps_.begin_walk(changes);
  const FoundPairs found = overlaps_.test(changes, {});
  note_slack(changes);
  timer.lap("tests");
  return found;
}

// What it takes to find everything anew elsewhere, nobody knows here.
void Stream::note_slack(const BodyChanges& changes) {
  if (!parts_.finder && do_most_move(changes)) slack_cost_.note(overlaps_.candidates(), pairs_);
}

// False when everything is to be found anew instead.
bool Stream::find_changed(const BodyChanges& changes, PhaseTimer& timer, FoundPairs& found) {
  const std::size_t count = fat_boxes_.changes().size();
  const PhaseTimer::Clock::time_point start = timer.last();
  crew_.plan(count, costs_.partial);
  const std::uint64_t tests = search_.tests();
  if (!search_.change(fat_boxes_.changes())) return false;
  compared_ = search_.tests() - tests;
  changed_ += count;
  timer.lap("cells");
  overlaps_.begin_walk(changes);
  const SlotPairChanges of_candidates =
      overlaps_.change_candidates(changes, fat_boxes_.changes(), search_.cells());
  timer.lap("sort");
  costs_.partial.learn(timer.last() - start, crew_.active(), count);
  found = overlaps_.test(changes, of_candidates);
  note_slack(changes);
  timer.lap("tests");
  return true;
}

// What was prepared takes the place of what there is, and follows the bodies that left their next fat boxes
// before these are in use.
FoundPairs Stream::find_prepared(const BodyChanges& changes, Kind& kind, PhaseTimer& timer) {
  overlaps_.set_aside(changes);
  search_.use_prepared();
  overlaps_.use_prepared();
  rebuild_.note_used(bodies_);
  slack_cost_.note_made();
  const std::size_t count = fat_boxes_.changes().size();
  if (count > 0) {
    crew_.plan(count, costs_.partial);
    if (!search_.change(fat_boxes_.changes())) {
      kind = kFull;
      return find_anew(changes, 0, timer);
    }
    overlaps_.change_candidates(changes, fat_boxes_.changes(), search_.cells());
  }
  changed_ += count;
  timer.lap("cells");
  const FoundPairs found = overlaps_.compare(changes);
  timer.lap("tests");
  return found;
}

FoundPairs Stream::find_all(const BodyChanges& changes, std::size_t most_swept, PhaseTimer& timer) {
  overlaps_.set_aside(changes);
  return find_anew(changes, most_swept, timer);
}

// An engine that has seen none of its bodies before goes by what earlier engines learnt.
FoundPairs Stream::find_anew(const BodyChanges& changes, std::size_t most_swept, PhaseTimer& timer) {
  const WorkCost::Clock::time_point start = WorkCost::Clock::now();
  const bool are_new = changes.inserted.size() == bodies_;
  crew_.plan(bodies_, are_new ? crew_.cost_of_new(bodies_) : costs_.full);
  search_.find_all(fat_boxes_, changes.boxes, most_swept);
  changed_ += bodies_;
  timer.lap("cells");
  overlaps_.replace(search_.found(), !fat_boxes_.have_slack());
  if (search_.has_cells()) overlaps_.make_room_for_few(changes);
  if (overlaps_.are_in_order(changes)) {
    overlaps_.put_in_order();
    timer.lap("sort");
  }
  const WorkCost::Clock::duration elapsed = WorkCost::Clock::now() - start;
  costs_.full.learn(elapsed, crew_.active(), bodies_);
  if (are_new && search_.has_cells()) crew_.cost_of_new(bodies_).learn(elapsed, crew_.active(), bodies_);
  const FoundPairs found = overlaps_.compare(changes);
  timer.lap("tests");
  return found;
}

FoundPairs Stream::counted(const FoundPairs& found) {
  const std::size_t began = found.began.size() + count_keys(found.more_began);
  pairs_ = pairs_ + began - found.ended.size();
  changed_pairs_ = began + found.ended.size();
  if (pairs_ > parts_.max_pairs) throw TooManyPairs();
  return found;
}

StreamView Stream::view(std::span<const Aabb> boxes) const {
  StreamView view;
  Bounds bounds;
  for (Slot slot = 0; slot < boxes.size(); ++slot) {
    const Aabb& fat = fat_boxes_.of(slot, boxes[slot]);
    if (!(fat.min[0] <= fat.max[0])) continue;  // nobody
    view.fat_boxes.push_back(fat);
    bounds.include(fat);
  }
  list_cell_bounds(search_.cells().root(), bounds.box(), view.cells);
  return view;
}

void Stream::note_idle(Statistics& statistics) {
  ++updates_[kIdle];
  was_full_ = false;
  statistics.phases.clear();
  if (statistics.counters.empty()) list_counters(statistics);
}

void Stream::count(Statistics& statistics) const {
  list_counters(statistics);
  statistics.bytes += bytes_held();
}

// Asks for memory in the first update alone.
void Stream::list_counters(Statistics& statistics) const {
  statistics.work = {changed_, search_.tests() + overlaps_.tests()};
  statistics.counters.assign({{"full updates", updates_[kFull]},
                              {"partial updates", updates_[kPartial]},
                              {"in-place updates", updates_[kInPlace]},
                              {"idle updates", updates_[kIdle]},
                              {"fat boxes put into cells", statistics.work.boxes_placed},
                              {"candidates", overlaps_.candidates()},
                              {"pieces", search_.cells().pieces()},
                              {"boxes in cells", search_.cells().copies()},
                              {"boxes compared", statistics.work.boxes_compared},
                              {"workers", crew_.active()},
                              {"vector lanes", parts_.kernels->lanes}});
  if (parts_.finder) parts_.finder->add_counters(statistics.counters);
}

}  // namespace cellsweep::stream
