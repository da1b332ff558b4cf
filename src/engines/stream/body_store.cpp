#include "engines/stream/body_store.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "broadphase/input_checks.h"
#include "broadphase/text.h"

namespace cellsweep::stream {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr Aabb kNobody = {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}};
/// Boxes given again are recognised so many at a time.
constexpr std::size_t kBlock = 32;

bool ascends(std::span<const BodyId> ids) {
  bool good = true;
  for (std::size_t i = 1; i < ids.size(); ++i) good &= ids[i - 1] < ids[i];
  return good;
}

bool is_run(const BodyId* ids, std::size_t count) {
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) good &= ids[i] == ids[0] + i;
  return good;
}

bool same_bits(const Aabb* one, const Aabb* other, std::size_t count) {
  return std::memcmp(one, other, count * sizeof(Aabb)) == 0;
}

// True when no box has a value that canonical() changes, or is invalid; may be false without a reason.
bool are_clean(const Aabb* boxes, std::size_t count) {
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float low = boxes[i].min[axis];
      const float high = boxes[i].max[axis];
      bad |= static_cast<std::uint32_t>(!(std::fabs(low) >= FLT_MIN)) |
             static_cast<std::uint32_t>(!(std::fabs(high) >= FLT_MIN)) |
             static_cast<std::uint32_t>(!(low >= -FLT_MAX)) | static_cast<std::uint32_t>(!(high <= FLT_MAX)) |
             static_cast<std::uint32_t>(!(low <= high));
    }
  }
  return bad == 0;
}

bool encloses(const Aabb& hull, const Aabb& box) {
  bool good = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    good &= hull.min[axis] <= box.min[axis];
    good &= box.max[axis] <= hull.max[axis];
  }
  return good;
}

/// Updates that a hull is made for when all are made anew, and at most when one is. Bodies that keep their
/// course leave their hulls all at once in the one case, which is when starting anew pays, and a share of
/// them each time in the other.
constexpr std::uint32_t kAllAhead = 8;
constexpr std::uint32_t kOneAhead = 12;
/// How much of its own length a box may grow on an axis; one that moves further at a time does not grow.
constexpr float kMostGrowth = 0.5F;

float growth(float from, float to, float edge, float updates) {
  const float step = to - from;
  if (!(std::fabs(step) <= edge)) return 0;
  return std::clamp(step * updates, -kMostGrowth * edge, kMostGrowth * edge);
}

// Encloses `now` and, the way that led from `old` to it, what comes next.
Aabb hull_of(const Aabb& old, const Aabb& now, float updates) {
  Aabb hull = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float edge = now.max[axis] - now.min[axis];
    const float low = now.min[axis] + growth(old.min[axis], now.min[axis], edge, updates);
    const float high = now.max[axis] + growth(old.max[axis], now.max[axis], edge, updates);
    hull.min[axis] = std::max(std::min(low, now.min[axis]), -FLT_MAX);
    hull.max[axis] = std::min(std::max(high, now.max[axis]), FLT_MAX);
  }
  return hull;
}

bool are_valid(std::span<const Aabb> boxes) {
  bool good = true;
  for (const Aabb& box : boxes) good &= is_valid(box);
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

Status BodyStore::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (!are_valid(boxes)) {
    if (Status status = first_invalid(ids, boxes); !status.ok()) return status;
  }
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
  table_.reserve_for(ids);
  boxes_.reserve(table_.slot_count() + ids.size());
  hulls_.reserve(table_.slot_count() + ids.size());
  if (changes_.size() + ids.size() > most_listed_) give_up_listing();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::uint32_t slot = table_.insert(ids[i]);
    if (slot == boxes_.size()) {
      boxes_.push_back(kNobody);
      hulls_.push_back(kNobody);
    }
    note_change(slot, false, true);
    boxes_[slot] = hulls_[slot] = canonical(boxes[i]);
  }
  return {};
}

// A worker's share of the checks, and which boxes differ from those held.
void BodyStore::check_moves(std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share,
                            Checked& checked) {
  checked.good = checked.clean = true;
  checked.count = checked.escapes = 0;
  if (checked.moved.size() < share.last - share.first) checked.moved.resize(share.last - share.first);
  const bool plain = table_.is_plain();
  for (std::size_t first = share.first; checked.good && first < share.last; first += kBlock) {
    const std::size_t last = std::min(first + kBlock, share.last);
    if (plain && ids[last - 1] < boxes_.size() && is_run(&ids[first], last - first)) {
      check_run(ids[first], boxes, {first, last}, checked);
    } else {
      check_some(ids, boxes, {first, last}, checked);
    }
  }
}

// Bodies whose slots follow one another: compared as a whole, then checked as a whole.
void BodyStore::check_run(std::uint32_t slot, std::span<const Aabb> boxes, Share share,
                          Checked& checked) const {
  const std::size_t count = share.last - share.first;
  if (same_bits(&boxes[share.first], &boxes_[slot], count)) return;
  if (!are_clean(&boxes[share.first], count)) {
    checked.clean = false;
    for (std::size_t i = share.first; i < share.last; ++i) checked.good &= is_valid(canonical(boxes[i]));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Aabb& box = boxes[share.first + i];
    const bool escapes = !encloses(hulls_[slot + i], box);
    const bool differs = !same_bits(&box, &boxes_[slot + i], 1);
    checked.moved[checked.count] = {static_cast<std::uint32_t>(share.first + i),
                                    static_cast<std::uint32_t>(slot + i), escapes};
    checked.count += differs ? 1 : 0;
    checked.escapes += differs && escapes ? 1 : 0;
  }
}

void BodyStore::check_some(std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share,
                           Checked& checked) const {
  for (std::size_t i = share.first; i < share.last; ++i) {
    const std::uint32_t slot = table_.find(ids[i]);
    if (slot == IdTable::kNone) {
      checked.good = false;
      return;
    }
    if (same_bits(&boxes[i], &boxes_[slot], 1)) continue;
    const Aabb box = canonical(boxes[i]);
    const bool escapes = !encloses(hulls_[slot], box);
    checked.good &= is_valid(box);
    checked.clean &= are_clean(&boxes[i], 1);
    checked.escapes += escapes ? 1 : 0;
    checked.moved[checked.count++] = {static_cast<std::uint32_t>(i), slot, escapes};
  }
}

Status BodyStore::move(Pool& pool, std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  if (ids.empty()) return {};
  checked_.resize(pool.workers());
  bool good = ascends(ids) || !find_duplicate(ids);
  pool.run([&](unsigned worker) {
    check_moves(ids, boxes, Share::of(ids.size(), worker, pool.active()), checked_[worker]);
  });
  std::size_t moved = 0;
  std::size_t escapes = 0;
  for (unsigned worker = 0; worker < pool.active(); ++worker) {
    good = good && checked_[worker].good;
    moved += checked_[worker].count;
    escapes += checked_[worker].escapes;
  }
  if (!good) return explain_refusal(ids, boxes);
  if (moved == 0) return {};
  if (changes_.size() + escapes > most_listed_) give_up_listing();
  if (!too_many_ && escapes > 0) {
    for (unsigned worker = 0; worker < pool.active(); ++worker) {
      for (const Moved& body : checked_[worker].view()) {
        if (body.escapes) note_change(body.slot, true, true);
      }
    }
  }
  moved_ = slack_ = true;
  pool.run([&](unsigned worker) {
    const Checked& checked = checked_[worker];
    if (checked.clean) {
      for (const Moved& body : checked.view()) apply(body, boxes[body.index]);
    } else {
      for (const Moved& body : checked.view()) apply(body, canonical(boxes[body.index]));
    }
  });
  return {};
}

void BodyStore::apply(const Moved& body, const Aabb& box) {
  if (too_many_) {
    hulls_[body.slot] = hull_of(boxes_[body.slot], box, kAllAhead);
  } else if (body.escapes) {
    const std::uint64_t chance = mix64(std::uint64_t{settled_} << 32 | body.slot);
    hulls_[body.slot] = hull_of(boxes_[body.slot], box, static_cast<float>(4 + chance % (kOneAhead - 3)));
  }
  boxes_[body.slot] = box;
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
  if (changes_.size() + ids.size() > most_listed_) give_up_listing();
  for (const BodyId id : ids) {
    const std::uint32_t slot = table_.remove(id);
    note_change(slot, true, false);
    boxes_[slot] = hulls_[slot] = kNobody;
  }
  return {};
}

// Called before the hull changes.
void BodyStore::note_change(std::uint32_t slot, bool was, bool is) {
  if (too_many_) return;
  if (listed_.size() < boxes_.size()) listed_.resize(boxes_.size() + boxes_.size() / 8, 0);
  if (listed_[slot] == 0) {
    changes_.push_back({slot, was, is, hulls_[slot], {}});
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
  for (Change& change : changes_) change.new_box = hulls_[change.slot];
  return changes_;
}

void BodyStore::tidy() {
  if (!table_.is_sparse()) return;
  const std::vector<std::uint32_t> before = table_.renumber();
  std::vector<Aabb> boxes;
  boxes.reserve(before.size());
  std::vector<Aabb> hulls;
  hulls.reserve(before.size());
  for (const std::uint32_t slot : before) {
    boxes.push_back(boxes_[slot]);
    hulls.push_back(hulls_[slot]);
  }
  boxes_ = std::move(boxes);
  hulls_ = std::move(hulls);
  give_up_listing();
  listed_ = {};
  for (Checked& checked : checked_) checked.moved = {};
}

void BodyStore::settle() {
  for (const Change& change : changes_) listed_[change.slot] = 0;
  changes_.clear();
  too_many_ = moved_ = false;
  ++settled_;
  table_.release();
  if (table_.slot_count() == 0) boxes_ = hulls_ = {};
}

std::size_t BodyStore::bytes() const {
  std::size_t sum = table_.bytes() + (boxes_.capacity() + hulls_.capacity()) * sizeof(Aabb) +
                    listed_.capacity() * sizeof(std::uint32_t) + changes_.capacity() * sizeof(Change);
  for (const Checked& checked : checked_) sum += checked.moved.capacity() * sizeof(Moved);
  return sum;
}

}  // namespace cellsweep::stream
