#include "engines/control/control.h"

#include <algorithm>
#include <string>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

namespace cellsweep::control {
namespace {

constexpr std::array<std::string_view, 3> kSortPhases = {"sort x", "sort y", "sort z"};

bool contains(std::span<const Slot> slots, Slot slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

}  // namespace

Control::Control(const EngineOptions& options) : options_(options) {}

Capacity Control::capacity() const {
  const std::uint64_t bodies = bodies_that_fit(options_.pair_map_bytes);
  if (bodies == kPairHashIds) {
    return {bodies, "", text("the document's pair key tells ", kPairHashIds, " bodies apart")};
  }
  return {bodies, "pair_map_bytes",
          text("its map of all possible pairs, ", kPairMapEntryBytes, " bytes each, is limited to ",
               options_.pair_map_bytes, " bytes")};
}

void Control::apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  boxes_.resize(bodies().slot_count());
  for (std::size_t i = 0; i < slots.size(); ++i) {
    boxes_[slots[i]] = boxes[i];
    new_slots_.push_back(slots[i]);
  }
}

void Control::apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) boxes_[slots[i]] = boxes[i];
}

void Control::apply_remove(std::span<const Slot> slots) {
  std::vector<bool> removed(bodies().slot_count(), false);
  for (const Slot slot : slots) {
    removed[slot] = true;
    if (!contains(new_slots_, slot)) forget_pairs_of(slot);
  }
  const auto is_removed = [&](Slot slot) { return removed[slot]; };
  std::erase_if(new_slots_, is_removed);
  for (EndpointList& list : axes_) {
    std::erase_if(list, [&](const Endpoint& end) { return is_removed(static_cast<Slot>(end.ownerID)); });
  }
}

// Takes the pairs of a body that is about to go out of the map; those that collided end.
void Control::forget_pairs_of(Slot slot) {
  std::erase(entered_, slot);
  for (const Slot other : entered_) {
    const PairInfo info = pair_manager_.remove(static_cast<int>(slot), static_cast<int>(other));
    if (info.colliding()) tracker_.note(pair_of(info), false);
  }
}

Result<PairChanges> Control::update() {
  PhaseTimer timer(statistics_.phases);
  fill_pair_map();
  timer.lap("fill pair map", true);
  append_endpoints();
  timer.lap("append endpoints");
  for (int axis = 0; axis < 3; ++axis) {
    sort_axis(axis);
    timer.lap(kSortPhases[axis]);
  }
  note_changed_pairs();
  const PairChanges changes = tracker_.commit();
  timer.lap("collect changes");
  ++statistics_.updates;
  refresh_counters();
  return changes;
}

// X1: every new body gets an entry with every other one.
void Control::fill_pair_map() {
  for (const Slot slot : new_slots_) {
    for (const Slot other : entered_) pair_manager_.add(static_cast<int>(slot), static_cast<int>(other));
    entered_.push_back(slot);
  }
}

// New endpoints stand behind all others, where they overlap nothing, until the sort takes them to their
// places.
void Control::append_endpoints() {
  for (const Slot slot : new_slots_) {
    const Aabb& box = boxes_[slot];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes_[axis].push_back({static_cast<int>(slot), &box, &box.min[axis]});
      axes_[axis].push_back({static_cast<int>(slot), &box, &box.max[axis]});
    }
  }
  new_slots_.clear();
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

void Control::refresh_counters() {
  statistics_.counters = {{"swaps", swaps_},
                          {"pair map entries", pair_manager_.size()},
                          {"pair map bytes", pair_manager_.size() * kPairMapEntryBytes}};
}

Pair Control::pair_of(const PairInfo& info) const {
  return make_pair_of(bodies().id(static_cast<Slot>(info.aID)), bodies().id(static_cast<Slot>(info.bID)));
}

}  // namespace cellsweep::control

namespace cellsweep {

Result<std::unique_ptr<Broadphase>> make_control(const EngineOptions& options) {
  if (options.pair_map_bytes < control::kPairMapEntryBytes) {
    return Status{StatusCode::bad_option,
                  text("pair_map_bytes is ", options.pair_map_bytes, "; one pair takes ",
                       control::kPairMapEntryBytes, " bytes, so at least that is needed."),
                  std::nullopt,
                  options.pair_map_bytes,
                  control::kPairMapEntryBytes,
                  "pair_map_bytes"};
  }
  return std::unique_ptr<Broadphase>(std::make_unique<control::Control>(options));
}

}  // namespace cellsweep
