#include "engines/stream/bodies/fat_boxes.h"

#include <algorithm>
#include <utility>

#include "base/threads/per_worker.h"
#include "base/tuning.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_box.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

List<Aabb> copy_of(std::span<const Aabb> boxes) {
  List<Aabb> copy;
  copy.reserve(boxes.size());
  copy.set_size(boxes.size());
  std::ranges::copy(boxes, copy.data());
  return copy;
}

/// Those of the last update, which the cells hold.
[[gnu::cold]] List<Aabb> boxes_before(const BodyChanges& changes) {
  List<Aabb> boxes = copy_of(changes.boxes);
  for (const Slot slot : changes.moved) boxes[slot] = changes.before[slot];
  for (const Slot slot : changes.removed) boxes[slot] = changes.before[slot];
  return boxes;
}

/// Notes for a share of those that moved who has left `fat_of(slot)`, as `has_left(slot)` says. Returns how
/// many have.
template <class FatOf, class HasLeft>
std::size_t note_each(std::span<const Slot> moved, Share share, std::uint8_t* escapes, const FatOf& fat_of,
                      const HasLeft& has_left) {
  // Of its own: else what they hold would be read again after each byte that is written.
  const FatOf fat = fat_of;
  const HasLeft is_out = has_left;
  std::size_t count = 0;
  for (std::size_t i = share.first; i < share.last; ++i) {
    __builtin_prefetch(&fat(moved[std::min(i + tuning::kAhead, share.last - 1)]));
    escapes[i] = is_out(moved[i]) ? 1 : 0;
    count += escapes[i];
  }
  return count;
}

/// Whether more than half of these are so, as some of them tell. No more are looked at once that is known.
template <class IsSo>
bool are_most(std::span<const Slot> slots, const IsSo& is_so) {
  constexpr std::size_t kLooks = 128;
  const std::size_t step = slots.size() / kLooks + 1;
  const std::size_t looks = (slots.size() + step - 1) / step;
  const std::size_t enough = looks / 2 + 1;
  std::size_t are = 0;
  std::size_t are_not = 0;
  for (std::size_t i = 0; i < slots.size(); i += step) {
    (is_so(slots[i]) ? are : are_not) += 1;
    if (are == enough) return true;
    if (are_not + enough > looks) return false;
  }
  return false;
}

}  // namespace

void FatBoxes::begin_update(const BodyChanges& changes) {
  changes_.clear();
  ++updates_;
  slack_ = slack_ || !changes.moved.empty();
  if (!slack_) return;
  const std::size_t slots = changes.boxes.size();
  if (fat_.are_by_slot()) {
    fat_.all().resize(slots, kNobody);
    courses_.all().resize(slots, Course::of_long_ago(updates_));
  } else if (SlotBlocks<Aabb>::suit(changes.moved.size(), slots)) {
    add_moved(changes);
  } else {
    lay_by_slot(boxes_before(changes));
  }
}

// Of bodies that move for the first time: what the cells hold.
void FatBoxes::add_moved(const BodyChanges& changes) {
  fat_.reserve(changes.boxes.size(), changes.moved.size());
  courses_.reserve(changes.boxes.size(), changes.moved.size());
  for (const Slot slot : changes.moved) {
    if (!fat_.add(slot)) continue;
    courses_.add(slot);
    fat_[slot] = changes.before[slot];
    courses_[slot] = Course::of_long_ago(updates_);
  }
}

// Of bodies that have none, these boxes.
void FatBoxes::lay_by_slot(List<Aabb> boxes) {
  List<Course> courses;
  courses.resize(boxes.size(), Course::of_long_ago(updates_));
  courses_.lay_by_slot(std::move(courses));
  fat_.lay_by_slot(std::move(boxes));
}

const Aabb* FatBoxes::by_slot(std::span<const Aabb> boxes) {
  if (!slack_) return boxes.data();
  if (!fat_.are_by_slot()) lay_by_slot(copy_of(boxes));
  return fat_.all().data();
}

void FatBoxes::begin_prepared(std::span<const Aabb> boxes) {
  // In memory that was just asked for, and is in the cache from being cleared: in that of the last ones
  // updates take 1.03 times as long (Xeon, uniform, varied and wall, 10,000).
  prepared_ = copy_of({by_slot(boxes), boxes.size()});
}

FatBoxes::Extent FatBoxes::take(Crew& crew, const BodyChanges& changes, const ListLimit& limit) {
  begin_update(changes);
  const std::size_t changed = find_escapes(crew, changes) + changes.removed.size() + changes.inserted.size();
  const bool too_many = changed > limit.most_listed;
  if (too_many || (changed > 0 && limit.left_soon > 0 && are_being_left(changes, limit.left_soon))) {
    renew_all(crew, changes);
    return Extent::all;
  }
  list(changes, changed);
  return changed == 0 ? Extent::inside : Extent::listed;
}

// One that trembles was given what lasted then.
void FatBoxes::refit(Crew& crew, const BodyChanges& changes) {
  begin_update(changes);
  escapes_.renew(changes.moved.size());
  std::fill_n(escapes_.data(), changes.moved.size(), std::uint8_t{1});
  for (const Slot slot : changes.moved) courses_[slot] = Course::of_long_ago(updates_);
  renew_all(crew, changes);
}

void FatBoxes::drop_slack() {
  fat_ = {};
  courses_ = {};
  drop_prepared();
  slack_ = false;
}

// Notes who of those in these places has left its fat box; `note` does so for a share. Returns how many have.
std::size_t FatBoxes::note_escapes(Crew& crew, std::size_t moved, Share places,
                                   FunctionRef<std::size_t(Share)> note) {
  escapes_.renew(moved);
  PerWorker<std::size_t> counts(crew.active());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(places.last - places.first, worker, crew.active());
    counts[worker] = note({places.first + share.first, places.first + share.last});
  });
  std::size_t sum = 0;
  for (const std::size_t count : counts.view()) sum += count;
  return sum;
}

std::size_t FatBoxes::find_escapes(Crew& crew, const BodyChanges& changes) {
  const Aabb* const boxes = changes.boxes.data();
  const auto note = [&](Share share, const auto& fat) {
    return note_each(
        changes.moved, share, escapes_.data(), [=](Slot slot) -> const Aabb& { return fat[slot]; },
        [=](Slot slot) { return !encloses(BoxLanes(fat[slot]), BoxLanes(boxes[slot])); });
  };
  const Aabb* const by_slot = fat_.all().data();
  return note_escapes(crew, changes.moved.size(), {0, changes.moved.size()}, [&](Share share) {
    return fat_.are_by_slot() ? note(share, by_slot) : note(share, SlotBoxes(fat_.blocks(), by_slot));
  });
}

// A body that trembles inside of its fat box keeps that: a next one, made by a step that happened to be
// short, would not last.
void FatBoxes::renew_all(Crew& crew, const BodyChanges& changes) {
  if (!slack_) return;
  by_slot(changes.boxes);  // as the cells will be given all of them
  for (const Slot slot : changes.removed) fat_[slot] = kNobody;
  for (const Slot slot : changes.inserted) fat_[slot] = changes.boxes[slot];
  crew.run([&](unsigned worker) {
    const Share share = Share::of(changes.moved.size(), worker, crew.active());
    for (std::size_t i = share.first; i < share.last; ++i) {
      const Slot slot = changes.moved[i];
      const bool escaped = escapes_.data()[i] != 0;
      if (!escaped && courses_[slot].trembles()) continue;
      fat_[slot] = grown(slot, changes.before[slot], changes.boxes[slot], escaped, tuning::kAllAhead);
    }
  });
}

// They will be used at a moment that is known, and half an update sooner and later, for a body does not keep
// its course to the last bit.
LaterOutlook FatBoxes::later_outlook(float from, float updates) const {
  return {.from = from - 0.5F, .updates = updates, .margin = margin_, .least = growth_.least};
}

void FatBoxes::prepare(Crew& crew, const BodyChanges& changes, Share places, float from, float updates) {
  const LaterOutlook outlook = later_outlook(from, updates);
  crew.run([&](unsigned worker) {
    const Share share = Share::of(places.last - places.first, worker, crew.active());
    for (std::size_t i = places.first + share.first; i < places.first + share.last; ++i) {
      const Slot slot = changes.moved[i];
      if (courses_[slot].trembles()) continue;
      prepared_[slot] = later_fat_box_of(changes.before[slot], changes.boxes[slot], outlook);
    }
  });
}

// One that trembles has the fat box that it had when others were prepared: it may have another one now.
std::size_t FatBoxes::find_escapes_from_prepared(Crew& crew, const BodyChanges& changes, Share places,
                                                 float from) {
  const auto has_left = [&](Slot slot) {
    const Aabb& fat = prepared_[slot];
    const Aabb& now = changes.boxes[slot];
    if (courses_[slot].trembles()) return !encloses(BoxLanes(fat), BoxLanes(now));
    return will_have_left(fat, changes.before[slot], now, from);
  };
  return note_escapes(crew, changes.moved.size(), places, [&](Share share) {
    return note_each(
        changes.moved, share, escapes_.data(), [&](Slot slot) -> const Aabb& { return prepared_[slot]; },
        has_left);
  });
}

std::span<const FatBoxChange> FatBoxes::mend_prepared(Crew& crew, const BodyChanges& changes, Share places,
                                                      float from, float updates) {
  mended_.clear();
  mended_.reserve(find_escapes_from_prepared(crew, changes, places, from));
  const LaterOutlook outlook = later_outlook(from, updates);
  for (std::size_t i = places.first; i < places.last; ++i) {
    if (escapes_.data()[i] == 0) continue;
    const Slot slot = changes.moved[i];
    const Aabb next = courses_[slot].trembles()
                          ? fat_[slot]
                          : later_fat_box_of(changes.before[slot], changes.boxes[slot], outlook);
    mended_.push({slot, true, true, prepared_[slot], next});
    prepared_[slot] = next;
  }
  return mended_.view();
}

bool FatBoxes::are_being_left(const BodyChanges& changes, float updates) const {
  return are_most(changes.moved, [&](Slot slot) {
    const Aabb course = course_of(changes.before[slot], changes.boxes[slot], updates);
    return !encloses(BoxLanes(fat_[slot]), BoxLanes(BoxNumbers::just_written(course)));
  });
}

bool FatBoxes::do_most_settle(const BodyChanges& changes) const {
  return are_most(changes.moved, [&](Slot slot) {
    if (has(slot) && courses_[slot].trembles()) return true;
    return step_in_lengths(changes.before[slot], changes.boxes[slot]) <= tuning::kCreepingStep;
  });
}

void FatBoxes::list(const BodyChanges& changes, std::size_t count) {
  if (count == 0) return;
  changes_.reserve(count);
  for (const Slot slot : changes.removed) list_removed(slot, changes.before[slot]);
  for (std::size_t i = 0; i < changes.moved.size(); ++i) {
    const Slot slot = changes.moved[i];
    if (escapes_.data()[i] != 0) list_moved(slot, changes.before[slot], changes.boxes[slot]);
  }
  for (const Slot slot : changes.inserted) list_inserted(slot, changes.boxes[slot]);
}

void FatBoxes::list_removed(Slot slot, const Aabb& before) {
  changes_.push({slot, true, false, of(slot, before), kNobody});
  if (has(slot)) fat_[slot] = kNobody;
}

// A body that leaves its fat box gets one for a number of updates that differs from body to body, so that
// they do not all leave theirs at once.
void FatBoxes::list_moved(Slot slot, const Aabb& before, const Aabb& now) {
  constexpr std::uint64_t kSpread = tuning::kOneAhead - tuning::kOneAheadAtLeast + 1;
  const std::uint64_t chance = mix64(std::uint64_t{updates_} << 32 | slot);
  const auto ahead = static_cast<float>(tuning::kOneAheadAtLeast + chance % kSpread);
  Aabb& fat = fat_[slot];
  const Aabb next = grown(slot, before, now, true, ahead);
  changes_.push({slot, true, true, fat, next});
  fat = next;
}

Aabb FatBoxes::grown(Slot slot, const Aabb& before, const Aabb& now, bool escaped, float updates) {
  const NextFatBox next = {updates_, updates, margin_, growth_};
  return courses_[slot].next_fat_box(fat_[slot], before, now, escaped, next);
}

void FatBoxes::list_inserted(Slot slot, const Aabb& now) {
  changes_.push({slot, false, true, kNobody, now});
  if (has(slot)) fat_[slot] = now;
}

void FatBoxes::give_back() {
  escapes_ = {};
  changes_ = {};
}

std::size_t FatBoxes::bytes() const {
  return fat_.bytes() + courses_.bytes() + prepared_.bytes() + escapes_.bytes() + changes_.bytes() +
         mended_.bytes();
}

}  // namespace cellsweep::stream
