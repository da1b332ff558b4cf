#include "broadphase/bodies/bodies.h"

#include <algorithm>
#include <utility>

#include "base/memory/array.h"
#include "base/text.h"
#include "broadphase/bodies/box_checks.h"
#include "broadphase/bodies/refusals.h"
#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep {
namespace {

/// Bodies as the last update saw them, whatever became of their ids since.
class SeenBodies {
 public:
  SeenBodies(const IdTable& table, const Vector<BodyState>& states, std::span<const ChangedBody> removed)
      : table_(table), states_(states) {
    gone_.reserve(removed.size());
    for (const ChangedBody& body : removed) gone_.emplace_back(table.id(body.slot), body.slot);
    std::sort(gone_.begin(), gone_.end());
  }

  /// The slot that the body of that id had, or kNoSlot.
  Slot find(BodyId id) const {
    const Slot slot = table_.find(id);
    if (slot != kNoSlot && states_[slot] != kInserted) return slot;
    const auto found = std::lower_bound(gone_.begin(), gone_.end(), std::pair(id, Slot{0}));
    return found != gone_.end() && found->first == id ? found->second : kNoSlot;
  }

 private:
  const IdTable& table_;
  const Vector<BodyState>& states_;
  std::vector<std::pair<BodyId, Slot>> gone_;
};

}  // namespace

Status Bodies::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes, std::string_view engine,
                      const Capacity& capacity) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  const bool clean = are_clean(boxes);
  if (!clean && !are_valid(boxes)) return find_invalid_boxes(ids, boxes);
  if (Status status = check_room(engine, capacity, ids.size()); !status.ok()) {
    if (Status twice = find_listed_twice(ids); !twice.ok()) return twice;
    if (Status held = find_held(table_, ids); !held.ok()) return held;
    return status;
  }
  const std::size_t slots = table_.slot_count() + ids.size();
  make_room(boxes_, slots);
  make_room(states_, slots);
  const std::size_t before = inserted_.size();
  if (!table_.insert(ids, inserted_)) {
    if (Status status = find_listed_twice(ids); !status.ok()) return status;
    return find_held(table_, ids);
  }
  write_inserted(std::span(inserted_).subspan(before), boxes, clean);
  return {};
}

// Slots that wait for the next update are nobody's.
Status Bodies::check_room(std::string_view engine, const Capacity& capacity, std::size_t more) const {
  const std::uint64_t slots = std::uint64_t{table_.slot_count()} + more;
  const std::uint64_t bodies = std::uint64_t{size()} + more;
  return check_capacity(engine, capacity, slots > kSlotMask ? std::max(slots, capacity.bodies + 1) : bodies);
}

// New slots come behind all others, in order; those that were free before are anywhere.
void Bodies::write_inserted(std::span<const Slot> slots, std::span<const Aabb> boxes, bool clean) {
  if (clean && !slots.empty() && slots.front() == boxes_.size()) {
    boxes_.insert(boxes_.end(), boxes.begin(), boxes.end());
    states_.resize(boxes_.size(), kInserted);
    return;
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i] == boxes_.size()) {
      boxes_.push_back(kNobody);
      states_.push_back(kGone);
    }
    boxes_[slots[i]] = canonical(boxes[i]);
    states_[slots[i]] = kInserted;
  }
}

Status Bodies::add(std::span<const Aabb> boxes, std::span<BodyId> ids, std::string_view engine,
                   const Capacity& capacity) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (!are_valid(boxes)) return find_invalid_boxes({}, boxes);
  if (Status status = check_room(engine, capacity, ids.size()); !status.ok()) return status;
  slots_.resize(ids.size());
  table_.choose_ids(slots_);
  if (Status status = insert(slots_, boxes, engine, capacity); !status.ok()) return status;
  std::copy(slots_.begin(), slots_.end(), ids.begin());
  return {};
}

Status Bodies::move(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (ids.empty()) return {};
  const std::size_t first = moved_.size();
  if (!check_moves(crew, ids, boxes)) {
    if (Status status = find_invalid_boxes(ids, boxes); !status.ok()) return status;
    return find_unknown(table_, ids);
  }
  gather_moves(crew, first, ids.size());
  keep_moves(first);
  return {};
}

// Writes what is to be moved behind the list of moved bodies, which does not grow by it. What one call needed
// the next one probably will, too.
bool Bodies::check_moves(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  checks_.resize(crew.workers());
  moved_.reserve(moved_.size() + ids.size());
  run_checks(crew, ids, boxes, ascended_ ? Unmoved::left_out : Unmoved::kept);
  ascended_ = checks_ascend(crew.active());
  if (!ascended_ && unmoved_ == Unmoved::left_out) run_checks(crew, ids, boxes, Unmoved::kept);
  return std::all_of(checks_.begin(), checks_.begin() + crew.active(),
                     [](const MoveCheck& check) { return check.good(); });
}

void Bodies::run_checks(Crew& crew, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                        Unmoved unmoved) {
  unmoved_ = unmoved;
  ChangedBody* const room = moved_.data() + moved_.size();
  const HeldBodies held{table_, boxes_.data(), states_.data()};
  crew.run([&](unsigned worker) {
    const Share share = Share::of(ids.size(), worker, crew.active());
    checks_[worker].run(held, ids, boxes, share, room + share.first, unmoved);
  });
}

bool Bodies::checks_ascend(unsigned workers) const {
  for (unsigned worker = 0; worker < workers; ++worker) {
    if (!checks_[worker].ascends()) return false;
    if (worker > 0 && checks_[worker].first() <= checks_[worker - 1].last()) return false;
  }
  return true;
}

// One after the other what each worker wrote at the beginning of its share.
void Bodies::gather_moves(Crew& crew, std::size_t first, std::size_t count) {
  std::size_t end = first;
  for (unsigned worker = 0; worker < crew.active(); ++worker) {
    const std::size_t from = first + Share::of(count, worker, crew.active()).first;
    const std::size_t moved = checks_[worker].moved();
    if (from != end) std::copy_n(moved_.data() + from, moved, moved_.data() + end);
    end += moved;
  }
  moved_.set_size(end);
}

// Those from `first` on are new to the list: of several boxes for a body the last one counts.
void Bodies::keep_moves(std::size_t first) {
  const bool may_be_unmoved = unmoved_ == Unmoved::kept;
  std::size_t kept = first;
  for (std::size_t i = first; i < moved_.size(); ++i) {
    const Slot slot = moved_[i].slot;
    if (states_[slot] != kAtRest) {
      move_again(moved_[i]);
      continue;
    }
    if (may_be_unmoved && same_bits(BoxLanes(moved_[i].before), BoxLanes(boxes_[slot]))) continue;
    if (kept != i) moved_[kept] = moved_[i];
    states_[slot] = static_cast<BodyState>(++kept);
  }
  moved_.set_size(kept);
}

// A body that has moved since the last update, or that none has seen.
void Bodies::move_again(const ChangedBody& body) {
  const BodyState state = states_[body.slot];
  if (state == kInserted) {
    boxes_[body.slot] = body.before;
  } else {
    moved_[state - 1].before = body.before;
  }
}

Status Bodies::remove(std::span<const BodyId> ids) {
  if (!ascends(ids)) {
    if (Status status = find_listed_twice(ids); !status.ok()) return status;
  }
  if (Status status = find_unknown(table_, ids); !status.ok()) return status;
  removed_.reserve(removed_.size() + ids.size());
  table_.reserve_removals(ids.size());
  for (const BodyId id : ids) {
    const Slot slot = table_.find(id);
    table_.remove(slot);
    const BodyState state = std::exchange(states_[slot], kGone);
    if (state == kInserted) {
      boxes_[slot] = kNobody;
      some_unseen_ = true;
      continue;
    }
    if (state != kAtRest) forget_move(state);
    removed_.push({kNobody, slot});
  }
  return {};
}

// The last one takes its place.
void Bodies::forget_move(BodyState state) {
  const ChangedBody last = moved_[moved_.size() - 1];
  moved_.set_size(moved_.size() - 1);
  if (state - 1 == moved_.size()) return;
  moved_[state - 1] = last;
  states_[last.slot] = state;
}

Status Bodies::boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  const SeenBodies seen(table_, states_, removed_.view());
  const auto is_unseen = [&](BodyId id) { return seen.find(id) == kNoSlot; };
  if (Status status = find_unseen(ids, is_unseen); !status.ok()) return status;
  for (std::size_t i = 0; i < ids.size(); ++i) boxes[i] = boxes_[seen.find(ids[i])];
  return {};
}

std::vector<BodyId> Bodies::removed_ids() const {
  std::vector<BodyId> ids;
  ids.reserve(removed_.size());
  for (const ChangedBody& body : removed_.view()) ids.push_back(table_.id(body.slot));
  std::sort(ids.begin(), ids.end());
  return ids;
}

void Bodies::swap_boxes() {
  for (ChangedBody& body : moved_.view()) std::swap(boxes_[body.slot], body.before);
  for (ChangedBody& body : removed_.view()) std::swap(boxes_[body.slot], body.before);
}

BodyChanges Bodies::begin_update() {
  if (some_unseen_) std::erase_if(inserted_, [&](Slot slot) { return states_[slot] == kGone; });
  some_unseen_ = false;
  swap_boxes();
  return {boxes_, removed_.view(), moved_.view(), inserted_, size()};
}

void Bodies::undo() {
  swap_boxes();
}

void Bodies::commit() {
  for (const ChangedBody& body : moved_.view()) states_[body.slot] = kAtRest;
  for (const Slot slot : inserted_) states_[slot] = kAtRest;
  moved_.clear();
  removed_.clear();
  inserted_.clear();
  table_.release();
  if (table_.slot_count() > 0 || boxes_.empty()) return;
  // With nobody left all memory goes back. The table goes on counting its versions.
  IdTable table = std::move(table_);
  *this = Bodies();
  table_ = std::move(table);
}

BodyChanges Bodies::all_as_new() {
  slots_.clear();
  slots_.reserve(size());
  for (Slot slot = 0; slot < boxes_.size(); ++slot) {
    if (boxes_[slot].min[0] <= boxes_[slot].max[0]) slots_.push_back(slot);
  }
  return {boxes_, {}, {}, slots_, size()};
}

bool Bodies::tidy() {
  if (!table_.is_sparse()) return false;
  Vector<Slot> before;
  IdTable table = table_.renumbered(before);
  Vector<Aabb> boxes;
  boxes.reserve(before.size());
  for (const Slot slot : before) boxes.push_back(boxes_[slot]);
  Vector<BodyState> states(before.size(), kAtRest);
  table_ = std::move(table);
  boxes_ = std::move(boxes);
  states_ = std::move(states);
  moved_ = {};
  removed_ = {};
  inserted_ = Vector<Slot>();
  slots_ = Vector<Slot>();
  return true;
}

std::size_t Bodies::bytes() const {
  return table_.bytes() + boxes_.capacity() * sizeof(Aabb) + states_.capacity() * sizeof(BodyState) +
         moved_.bytes() + removed_.bytes() + (inserted_.capacity() + slots_.capacity()) * sizeof(Slot);
}

}  // namespace cellsweep
