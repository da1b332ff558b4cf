#include "broadphase/bodies/staged_boxes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <numeric>
#include <utility>

#include "base/threads/per_worker.h"
#include "broadphase/bodies/box_checks.h"
#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep {
namespace {

/// Boxes given again are recognised so many at a time.
constexpr std::size_t kMoveBlock = 32;
/// New boxes are looked at and copied so many at a time, which are in the fastest cache then.
constexpr std::size_t kStageBlock = 128;

/// Looks at all of them, which takes less than to stop early.
bool are_all(const BodyState* states, std::size_t count, BodyState state) {
  unsigned others = 0;
  for (std::size_t i = 0; i < count; ++i) others |= static_cast<unsigned>(states[i] ^ state);
  return others == 0;
}

/// Moves one body after the other.
struct Move {
  Aabb* boxes;
  SlotBlocks<Aabb>::Places next;
  BodyState* states;

  // A body that has moved already, to somewhere else, may be told to stay.
  Slot* one(Slot slot, const Aabb& box, Slot* moved) const {
    const BodyState state = states[slot];
    if (state == kInserted) {
      boxes[slot] = box;
      return moved;
    }
    const bool differs = !same_bits(BoxLanes(box), BoxLanes(boxes[slot]));
    next[slot] = box;
    if (state == kMoved) return moved;
    states[slot] = differs ? kMoved : kAtRest;
    *moved = slot;
    return moved + (differs ? 1 : 0);
  }
};

// Few callers have any that are not.
[[gnu::cold, gnu::noinline]] void make_canonical(std::span<const Aabb> boxes, Aabb* to) {
  for (const Aabb& box : boxes) *to++ = canonical(box);
}

}  // namespace

bool StagedBoxes::are_at_rest(Slot first, std::size_t count) const {
  return are_all(&states_[first], count, kAtRest);
}

bool StagedBoxes::are_at_rest(Slot first, std::span<const Aabb> boxes) const {
  return std::memcmp(boxes.data(), &boxes_[first], boxes.size_bytes()) == 0 &&
         are_at_rest(first, boxes.size());
}

void StagedBoxes::reserve(std::size_t slots) {
  boxes_.reserve(slots);
  states_.reserve(slots);
  if (next_.are_by_slot()) next_.all().reserve(slots);
}

bool StagedBoxes::stage(Crew& crew, std::span<const Aabb> boxes) {
  std::atomic<bool> clean = true;
  Aabb* const to = boxes_.data() + boxes_.size();
  crew.run([&](unsigned worker) {
    const Share share = Share::of(boxes.size(), worker, crew.active());
    bool all = true;
    for (std::size_t first = share.first; first < share.last; first += kStageBlock) {
      const auto block = boxes.subspan(first, std::min(kStageBlock, share.last - first));
      all = all && are_clean(block);
      std::ranges::copy(block, to + first);
    }
    if (!all) clean = false;
  });
  return clean;
}

void StagedBoxes::insert_staged(std::size_t count) {
  boxes_.set_size(boxes_.size() + count);
  states_.resize(boxes_.size(), kInserted);
}

void StagedBoxes::insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i] == boxes_.size()) {
      boxes_.push(kNobody);
      states_.push(kGone);
    }
    boxes_[slots[i]] = canonical(boxes[i]);
    states_[slots[i]] = kInserted;
  }
}

// So many more may change.
void StagedBoxes::reserve_next(std::size_t more) {
  const std::size_t changed = moved_.size() + removed_.size() + more;
  const bool are_few = SlotBlocks<Aabb>::suit(changed, boxes_.size());
  if (!are_few) quiet_ = 0;
  if (next_.are_by_slot()) return;
  if (are_few) return next_.reserve(boxes_.size(), more);
  List<Aabb> all;
  all.reserve(boxes_.capacity());
  all.set_size(boxes_.size());
  next_.lay_by_slot(std::move(all));
}

void StagedBoxes::move(Crew& crew, const MovedBodies& bodies) {
  const std::size_t count = bodies.slots.size();
  const std::size_t before = moved_.size();
  moved_.reserve(before + count);
  const unsigned workers = bodies.ascends ? crew.active() : 1;
  PerWorker<std::size_t> written(workers);
  reserve_next(count);
  if (!next_.are_by_slot()) {
    for (const Slot slot : bodies.slots) next_.add(slot);
  }
  Slot* const room = moved_.data() + before;
  if (workers > 1) {
    crew.run([&](unsigned worker) {
      const Share share = Share::of(count, worker, workers);
      written[worker] = move_share(bodies, share, room + share.first);
    });
  } else {
    written[0] = move_share(bodies, {0, count}, room);
  }
  std::size_t end = written[0];
  for (unsigned worker = 1; worker < workers; ++worker) {
    const Slot* from = room + Share::of(count, worker, workers).first;
    std::copy_n(from, written[worker], room + end);
    end += written[worker];
  }
  moved_.set_size(before + end);
}

// Returns how many slots it wrote to the list.
std::size_t StagedBoxes::move_share(const MovedBodies& bodies, Share share, Slot* moved) {
  Slot* end = moved;
  for (std::size_t first = share.first; first < share.last; first += kMoveBlock) {
    const std::size_t count = std::min(kMoveBlock, share.last - first);
    end = move_block({bodies.slots.subspan(first, count), bodies.boxes.subspan(first, count), bodies.clean,
                      bodies.ascends},
                     end);
  }
  return static_cast<std::size_t>(end - moved);
}

// Where one body of consecutive slots moves, its neighbours mostly do, too: what they have need not be read
// then, for a body may be listed that stays.
Slot* StagedBoxes::move_block(const MovedBodies& block, Slot* moved) {
  const std::size_t count = block.slots.size();
  const Slot first = block.slots[0];
  const bool is_run =
      block.clean && block.ascends && next_.are_by_slot() && block.slots[count - 1] - first == count - 1;
  if (is_run && are_at_rest(first, count)) {
    if (std::memcmp(block.boxes.data(), &boxes_[first], block.boxes.size_bytes()) == 0) return moved;
    if (!same_bits(BoxLanes(block.boxes[0]), BoxLanes(boxes_[first]))) {
      std::memcpy(&next_[first], block.boxes.data(), block.boxes.size_bytes());
      std::memset(&states_[first], kMoved, count);
      std::iota(moved, moved + count, first);
      return moved + count;
    }
  }
  const Move move{boxes_.data(), SlotBlocks<Aabb>::Places(next_), states_.data()};
  const auto put = [&](const Aabb* boxes) {
    for (std::size_t i = 0; i < count; ++i) moved = move.one(block.slots[i], boxes[i], moved);
    return moved;
  };
  if (block.clean) return put(block.boxes.data());
  std::array<Aabb, kMoveBlock> canonical_boxes;
  make_canonical(block.boxes, canonical_boxes.data());
  return put(canonical_boxes.data());
}

void StagedBoxes::reserve_removals(std::size_t count) {
  removed_.reserve(removed_.size() + count);
  reserve_next(count);
}

void StagedBoxes::remove(Slot slot) {
  const BodyState state = std::exchange(states_[slot], kGone);
  if (state == kInserted) {
    boxes_[slot] = kNobody;
    return;
  }
  some_moved_are_gone_ = some_moved_are_gone_ || state == kMoved;
  if (!next_.are_by_slot()) next_.add(slot);
  next_[slot] = kNobody;
  removed_.push(slot);
}

BodyChanges StagedBoxes::begin_update() {
  if (some_moved_are_gone_) {
    moved_.erase_if([&](Slot slot) { return states_[slot] == kGone; });
    some_moved_are_gone_ = false;
  }
  swapped_all_ = moved_.size() > boxes_.size() / 2;
  if (next_.are_by_slot()) next_.all().set_size(boxes_.size());
  if (swapped_all_) {
    swap_all();
  } else {
    swap_changed();
  }
  return {boxes(), {next_.blocks(), next_.all().data()}, removed_.view(), moved_.view(), {}, 0};
}

void StagedBoxes::swap_all() {
  List<Aabb>& next = next_.all();
  if (moved_.size() < boxes_.size()) {
    for (Slot slot = 0; slot < boxes_.size(); slot += kMoveBlock) {
      const auto end = static_cast<Slot>(std::min(slot + kMoveBlock, boxes_.size()));
      if (are_all(&states_[slot], end - slot, kMoved)) continue;
      for (Slot still = slot; still < end; ++still) {
        if (states_[still] != kMoved) next[still] = boxes_[still];
      }
    }
    for (const Slot slot : removed_.view()) next[slot] = kNobody;
  }
  std::swap(boxes_, next_.all());
}

void StagedBoxes::swap_changed() {
  for (const Slot slot : moved_.view()) std::swap(boxes_[slot], next_[slot]);
  for (const Slot slot : removed_.view()) std::swap(boxes_[slot], next_[slot]);
}

void StagedBoxes::undo() {
  if (swapped_all_) {
    std::swap(boxes_, next_.all());
  } else {
    swap_changed();
  }
}

void StagedBoxes::commit(std::span<const Slot> inserted) {
  if (moved_.size() + inserted.size() == states_.size()) {
    std::fill_n(states_.data(), states_.size(), kAtRest);  // these are all: none is there twice
  } else {
    for (const Slot slot : moved_.view()) states_[slot] = kAtRest;
    for (const Slot slot : inserted) states_[slot] = kAtRest;
  }
  if (!next_.are_by_slot()) next_.clear();
  moved_.clear();
  removed_.clear();
  ++quiet_;
  if (has_come_to_rest()) give_back();
}

void StagedBoxes::give_back() {
  next_ = {};
  moved_ = {};
  removed_ = {};
}

void StagedBoxes::renumber(std::span<const Slot> before) {
  List<Aabb> boxes;
  boxes.reserve(before.size());
  for (const Slot slot : before) boxes.push(boxes_[slot]);
  List<BodyState> states;
  states.resize(before.size(), kAtRest);
  *this = StagedBoxes();
  boxes_ = std::move(boxes);
  states_ = std::move(states);
}

std::size_t StagedBoxes::bytes() const {
  return boxes_.bytes() + next_.bytes() + states_.bytes() + moved_.bytes() + removed_.bytes();
}

}  // namespace cellsweep
