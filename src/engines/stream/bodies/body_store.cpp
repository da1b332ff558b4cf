#include "engines/stream/bodies/body_store.h"

#include <algorithm>
#include <utility>

#include "broadphase/input_checks.h"
#include "base/text.h"
#include "engines/stream/bodies/hull.h"

namespace cellsweep::stream {
namespace {

/// Updates that a hull is made for when all are made anew, and at most when one is. Bodies that keep their
/// course leave their hulls all at once in the one case, which is when starting anew pays, and a share of
/// them each time in the other.
constexpr std::uint32_t kAllAhead = 8;
constexpr std::uint32_t kOneAhead = 12;

bool ascends(std::span<const BodyId> ids) {
  bool good = true;
  for (std::size_t i = 1; i < ids.size(); ++i) good &= ids[i - 1] < ids[i];
  return good;
}

Status first_invalid(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!is_valid(canonical(boxes[i]))) return invalid_box_status(ids[i], boxes[i]);
  }
  return {};
}

Status capacity_status(std::uint64_t wanted) {
  return {StatusCode::capacity,
          text("Engine stream takes ", kSlotMask, " bodies, ", wanted,
               " were asked for: a slot's number has ", kSlotBits, " bits; no setting raises this limit."),
          std::nullopt,
          wanted,
          kSlotMask,
          ""};
}

}  // namespace

Status BodyStore::check_insert(std::span<const BodyId> ids) const {
  if (!ascends(ids)) {
    if (const auto twice = find_duplicate(ids))
      return duplicate_body_status(*twice, "listed twice in one call");
  }
  if (table_.size() > 0) {
    for (const BodyId id : ids) {
      if (table_.find(id) != IdTable::kNone) return duplicate_body_status(id, "in the engine already");
    }
  }
  if (const std::uint64_t wanted = std::uint64_t{table_.slot_count()} + ids.size(); wanted > kSlotMask) {
    return capacity_status(wanted);
  }
  return {};
}

Status BodyStore::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  const bool clean = are_clean(boxes);
  if (!clean) {
    if (Status status = first_invalid(ids, boxes); !status.ok()) return status;
  }
  if (Status status = check_insert(ids); !status.ok()) return status;
  table_.reserve_for(ids);
  const std::size_t slots = table_.slot_count() + ids.size();
  make_room(boxes_, slots);
  make_room(stamps_, slots);
  if (slack_) make_room(hulls_, slots);
  plan_listing(ids.size());
  fresh_ += ids.size();
  if (clean && too_many_ && table_.appends()) {
    append(ids, boxes);
    return {};
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t slot = table_.insert(ids[i]);
    if (slot == boxes_.size()) {
      boxes_.push_back(kNobody);
      stamps_.push_back(0);
      if (slack_) hulls_.push_back(kNobody);
    }
    note_change(slot, false, true);
    put(slot, canonical(boxes[i]));
  }
  return {};
}

// Boxes that nothing needs to be done to, behind all others.
void BodyStore::append(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  table_.append(ids);
  boxes_.insert(boxes_.end(), boxes.begin(), boxes.end());
  if (slack_) hulls_.insert(hulls_.end(), boxes.begin(), boxes.end());
  stamps_.resize(boxes_.size(), stamp_);
}

// A box that is its own hull.
void BodyStore::put(std::uint32_t slot, const Aabb& box) {
  boxes_[slot] = box;
  if (slack_) hulls_[slot] = box;
  stamps_[slot] = stamp_;
}

// `more` changes of hulls are to come: takes the memory to list them, or gives up.
void BodyStore::plan_listing(std::size_t more) {
  if (changes_.size() + more > most_listed_) give_up_listing();
  if (too_many_ || more == 0) return;
  make_room(changes_, changes_.size() + more);
  const std::size_t slots = boxes_.capacity();
  if (listed_.size() < slots) listed_.resize(slots, 0);
}

void BodyStore::make_hulls() {
  if (slack_) return;
  make_room(hulls_, boxes_.capacity());
  hulls_ = boxes_;
  slack_ = true;
}

void BodyStore::drop_hulls() {
  give_up_listing();
  hulls_ = {};
  slack_ = false;
}

Status BodyStore::move(Pool& pool, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (ids.empty()) return {};
  checks_.resize(pool.workers());
  const std::span<MoveCheck> checks(checks_.data(), pool.active());
  bool good = ascends(ids) || !find_duplicate(ids);
  const HeldBoxes held{table_, boxes_, hull_data()};
  pool.run([&](unsigned worker) {
    checks[worker].run(held, ids, boxes, Share::of(ids.size(), worker, pool.active()));
  });
  std::size_t moved = 0;
  std::size_t escapes = 0;
  for (const MoveCheck& check : checks) {
    good = good && check.good();
    moved += check.moved().size();
    escapes += check.escapes();
  }
  if (!good) return explain_refusal(ids, boxes);
  if (moved == 0) return {};
  make_hulls();
  plan_listing(escapes);
  if (!too_many_ && escapes > 0) {
    for (const MoveCheck& check : checks) {
      for (const MovedBody& body : check.moved()) {
        if (body.escapes) note_change(body.slot, true, true);
      }
    }
  }
  moved_ = true;
  fresh_ += moved;
  pool.run([&](unsigned worker) {
    const MoveCheck& check = checks[worker];
    if (check.clean()) {
      for (const MovedBody& body : check.moved()) apply(body, boxes[body.index]);
    } else {
      for (const MovedBody& body : check.moved()) apply(body, canonical(boxes[body.index]));
    }
  });
  return {};
}

void BodyStore::apply(const MovedBody& body, const Aabb& box) {
  if (too_many_) {
    hulls_[body.slot] = hull_of(boxes_[body.slot], box, kAllAhead);
  } else if (body.escapes) {
    const std::uint64_t chance = mix64(std::uint64_t{settled_} << 32 | body.slot);
    hulls_[body.slot] = hull_of(boxes_[body.slot], box, static_cast<float>(4 + chance % (kOneAhead - 3)));
  }
  boxes_[body.slot] = box;
  stamps_[body.slot] = stamp_;
}

// The first fault in the order that every engine keeps.
Status BodyStore::explain_refusal(std::span<const BodyId> ids, std::span<const Aabb> boxes) const {
  if (Status status = first_invalid(ids, boxes); !status.ok()) return status;
  if (const auto twice = find_duplicate(ids))
    return duplicate_body_status(*twice, "listed twice in one call");
  for (const BodyId id : ids) {
    if (table_.find(id) == IdTable::kNone) return unknown_body_status(id);
  }
  return {};
}

Status BodyStore::remove(std::span<const BodyId> ids) {
  if (const auto twice = find_duplicate(ids))
    return duplicate_body_status(*twice, "listed twice in one call");
  for (const BodyId id : ids) {
    if (table_.find(id) == IdTable::kNone) return unknown_body_status(id);
  }
  table_.reserve_removals(ids.size());
  plan_listing(ids.size());
  for (const BodyId id : ids) {
    const std::uint32_t slot = table_.remove(id);
    note_change(slot, true, false);
    put(slot, kNobody);
  }
  return {};
}

// Called before the hull changes, with memory for it.
void BodyStore::note_change(std::uint32_t slot, bool was, bool is) {
  if (too_many_) return;
  if (listed_[slot] == 0) {
    changes_.push_back({slot, was, is, hull_data()[slot], {}});
    listed_[slot] = static_cast<std::uint32_t>(changes_.size());
  } else {
    changes_[listed_[slot] - 1].is = is;
  }
}

void BodyStore::give_up_listing() {
  if (too_many_) return;
  for (const Change& change : changes_) listed_[change.slot] = 0;
  changes_.clear();
  too_many_ = true;
}

std::span<const Change> BodyStore::changes() {
  std::erase_if(changes_, [&](const Change& change) {
    const bool never_seen = !change.was && !change.is;
    if (never_seen) listed_[change.slot] = 0;
    return never_seen;
  });
  for (Change& change : changes_) change.new_box = hull_data()[change.slot];
  return changes_;
}

void BodyStore::tidy() {
  if (!table_.is_sparse()) return;
  BoxVector boxes;
  boxes.reserve(table_.size());
  BoxVector hulls;
  hulls.reserve(slack_ ? table_.size() : 0);
  Vector<std::uint8_t> stamps(table_.size(), stamp_);
  for (const std::uint32_t slot : table_.renumber()) {
    boxes.push_back(boxes_[slot]);
    if (slack_) hulls.push_back(hulls_[slot]);
  }
  boxes_ = std::move(boxes);
  hulls_ = std::move(hulls);
  stamps_ = std::move(stamps);
  give_up_listing();
  listed_ = {};
  for (MoveCheck& check : checks_) check.give_back();
}

void BodyStore::settle() {
  for (const Change& change : changes_) listed_[change.slot] = 0;
  changes_.clear();
  too_many_ = moved_ = false;
  ++settled_;
  fresh_ = 0;
  if (++stamp_ == 0) {
    std::fill(stamps_.begin(), stamps_.end(), std::uint8_t{0});
    stamp_ = 1;
  }
  table_.release();
  if (table_.slot_count() > 0) return;
  boxes_ = hulls_ = {};
  stamps_ = {};
  slack_ = false;
}

std::size_t BodyStore::bytes() const {
  std::size_t sum = table_.bytes() + (boxes_.capacity() + hulls_.capacity()) * sizeof(Aabb) +
                    stamps_.capacity() + listed_.capacity() * sizeof(std::uint32_t) +
                    changes_.capacity() * sizeof(Change);
  for (const MoveCheck& check : checks_) sum += check.bytes();
  return sum;
}

}  // namespace cellsweep::stream
