#include "engines/stream/bodies/fat_boxes.h"

#include <vector>

#include "base/tuning.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_box.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

FatBoxes::Extent FatBoxes::take(Crew& crew, const BodyChanges& changes, std::size_t most_listed) {
  changes_.clear();
  ++updates_;
  if (!slack_ && !changes.moved.empty()) make_slack(changes);
  if (slack_) {
    make_room(fat_, changes.boxes.size());
    fat_.resize(changes.boxes.size(), kNobody);
  }
  const std::size_t changed = find_escapes(crew, changes) + changes.removed.size() + changes.inserted.size();
  if (changed > most_listed) {
    renew_all(crew, changes);
    return Extent::all;
  }
  list(changes, changed);
  return changed == 0 ? Extent::inside : Extent::listed;
}

// The boxes as they were: the cells hold these.
void FatBoxes::make_slack(const BodyChanges& changes) {
  fat_.assign(changes.boxes.begin(), changes.boxes.end());
  for (const ChangedBody& body : changes.moved) fat_[body.slot] = body.before;
  for (const ChangedBody& body : changes.removed) fat_[body.slot] = body.before;
  slack_ = true;
}

void FatBoxes::drop_slack() {
  fat_ = Vector<Aabb>();
  slack_ = false;
}

std::size_t FatBoxes::find_escapes(Crew& crew, const BodyChanges& changes) {
  const std::span<const ChangedBody> moved = changes.moved;
  escapes_.renew(moved.size());
  std::vector<std::size_t> counts(crew.active());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(moved.size(), worker, crew.active());
    std::size_t count = 0;
    for (std::size_t i = share.first; i < share.last; ++i) {
      const Slot slot = moved[i].slot;
      const bool escapes = !encloses(BoxLanes(fat_[slot]), BoxLanes(changes.boxes[slot]));
      escapes_.data()[i] = escapes ? 1 : 0;
      count += escapes ? 1 : 0;
    }
    counts[worker] = count;
  });
  std::size_t sum = 0;
  for (const std::size_t count : counts) sum += count;
  return sum;
}

void FatBoxes::renew_all(Crew& crew, const BodyChanges& changes) {
  if (!slack_) return;
  for (const ChangedBody& body : changes.removed) fat_[body.slot] = kNobody;
  for (const Slot slot : changes.inserted) fat_[slot] = changes.boxes[slot];
  crew.run([&](unsigned worker) {
    const Share share = Share::of(changes.moved.size(), worker, crew.active());
    for (std::size_t i = share.first; i < share.last; ++i) {
      const ChangedBody& body = changes.moved[i];
      fat_[body.slot] = fat_box_of(body.before, changes.boxes[body.slot], tuning::kAllAhead);
    }
  });
}

void FatBoxes::list(const BodyChanges& changes, std::size_t count) {
  if (count == 0) return;
  changes_.reserve(count);
  for (const ChangedBody& body : changes.removed) list_removed(body);
  for (std::size_t i = 0; i < changes.moved.size(); ++i) {
    const ChangedBody& body = changes.moved[i];
    if (escapes_.data()[i] != 0) list_moved(body, changes.boxes[body.slot]);
  }
  for (const Slot slot : changes.inserted) list_inserted(slot, changes.boxes[slot]);
}

void FatBoxes::list_removed(const ChangedBody& body) {
  changes_.push({body.slot, true, false, slack_ ? fat_[body.slot] : body.before, kNobody});
  if (slack_) fat_[body.slot] = kNobody;
}

// A body that leaves its fat box gets one for a number of updates that differs from body to body, so that
// they do not all leave theirs at once.
void FatBoxes::list_moved(const ChangedBody& body, const Aabb& now) {
  constexpr std::uint64_t kSpread = tuning::kOneAhead - tuning::kOneAheadAtLeast + 1;
  const std::uint64_t chance = mix64(std::uint64_t{updates_} << 32 | body.slot);
  const auto ahead = static_cast<float>(tuning::kOneAheadAtLeast + chance % kSpread);
  Aabb& fat = fat_[body.slot];
  const Aabb grown = fat_box_of(body.before, now, ahead);
  changes_.push({body.slot, true, true, fat, grown});
  fat = grown;
}

void FatBoxes::list_inserted(Slot slot, const Aabb& now) {
  changes_.push({slot, false, true, kNobody, now});
  if (slack_) fat_[slot] = now;
}

std::size_t FatBoxes::bytes() const {
  return fat_.capacity() * sizeof(Aabb) + escapes_.bytes() + changes_.bytes();
}

}  // namespace cellsweep::stream
