#include "engines/control/control.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

namespace cellsweep::control {
namespace {

constexpr std::array<std::string_view, 3> kSortPhases = {"sort x", "sort y", "sort z"};

}  // namespace

Control::Control(const ControlOptions& options) : options_(options) {}

Capacity Control::capacity() const {
  const std::uint64_t bodies = bodies_that_fit(options_.pair_map_bytes);
  if (bodies == kPairHashIds) {
    return {bodies, "", text("the document's pair key tells ", kPairHashIds, " bodies apart")};
  }
  return {bodies, "pair_map_bytes",
          text("its map of all possible pairs, ", kPairMapEntryBytes, " bytes each, is limited to ",
               options_.pair_map_bytes, " bytes")};
}

void Control::apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) {
  boxes_.resize(place_count());
  apply_move(places, boxes);
  new_places_.assign(places.begin(), places.end());
}

void Control::apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < places.size(); ++i) boxes_[places[i]] = boxes[i];
}

void Control::apply_remove(std::span<const Slot> places) {
  std::vector<bool> removed(place_count(), false);
  for (const Slot place : places) {
    removed[place] = true;
    forget_pairs_of(place);
  }
  for (EndpointList& list : axes_) {
    std::erase_if(list, [&](const Endpoint& end) { return removed[static_cast<Slot>(end.ownerID)]; });
  }
}

// Takes the pairs of a body that has gone out of the map; those that collided end.
void Control::forget_pairs_of(Slot place) {
  std::erase(entered_, place);
  for (const Slot other : entered_) {
    const PairInfo info = pair_manager_.remove(static_cast<int>(place), static_cast<int>(other));
    if (info.colliding()) tracker_.note(pair_of(info), false);
  }
}

Result<FoundPairs> Control::find_pairs(Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  fill_pair_map();
  timer.lap("fill pair map", PhaseKind::setup);
  append_endpoints();
  timer.lap("append endpoints");
  for (int axis = 0; axis < 3; ++axis) {
    sort_axis(axis);
    timer.lap(kSortPhases[static_cast<std::size_t>(axis)]);
  }
  note_changed_pairs();
  const FoundPairs found = tracker_.commit();
  timer.lap("collect changes");
  const std::uint64_t map_bytes = pair_manager_.size() * kPairMapEntryBytes;
  statistics.counters = {
      {"swaps", swaps_}, {"pair map entries", pair_manager_.size()}, {"pair map bytes", map_bytes}};
  statistics.bytes += map_bytes;
  return found;
}

// X1: every new body gets an entry with every other one.
void Control::fill_pair_map() {
  for (const Slot place : new_places_) {
    for (const Slot other : entered_) pair_manager_.add(static_cast<int>(place), static_cast<int>(other));
    entered_.push_back(place);
  }
}

// New endpoints stand behind all others, where they overlap nothing, until the sort takes them to their
// places.
void Control::append_endpoints() {
  for (const Slot place : new_places_) {
    const Aabb& box = boxes_[place];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes_[axis].push_back({static_cast<int>(place), &box, &box.min[axis]});
      axes_[axis].push_back({static_cast<int>(place), &box, &box.max[axis]});
    }
  }
  new_places_.clear();
}

void Control::sort_axis(int axis) {
  SortEvents events{&changed_};
  const auto sort = options_.literal ? sort_and_test_literal : sort_and_test;
  sort(axes_[axis], axis, pair_manager_, events);
  swaps_ += events.swaps;
}

void Control::note_changed_pairs() {
  for (const PairInfo& info : changed_) tracker_.note(pair_of(info), info.colliding());
  changed_.clear();
}

SlotPair Control::pair_of(const PairInfo& info) const {
  return slots(static_cast<Slot>(info.aID), static_cast<Slot>(info.bID));
}

}  // namespace cellsweep::control

namespace cellsweep {

Result<Broadphase> make_broadphase(const ControlOptions& options) {
  if (options.pair_map_bytes < control::kPairMapEntryBytes) {
    return Status::bad_option("pair_map_bytes",
                              text("pair_map_bytes is ", options.pair_map_bytes, "; one pair takes ",
                                   control::kPairMapEntryBytes, " bytes, so at least that is needed."),
                              options.pair_map_bytes, control::kPairMapEntryBytes);
  }
  const auto make = [options]() -> Result<std::unique_ptr<Engine>> {
    return std::unique_ptr<Engine>(std::make_unique<control::Control>(options));
  };
  return EngineAccess::make("control", make, options.trace, "control");
}

}  // namespace cellsweep
