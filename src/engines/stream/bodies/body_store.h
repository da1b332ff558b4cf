/// @file
/// Bodies and boxes of engine `stream`, checked on the way in, and what changed since the last update.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "broadphase/bodies/id_table.h"
#include "engines/stream/bodies/move_check.h"
#include "engines/stream/cells/cell_tree.h"
#include "base/memory/memory.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// Every body has two boxes: its own, and a hull around it in which it may move about. Hulls are what the
/// cells hold; while a body stays inside of its hull, no cell changes. A hull is the box itself until the
/// body moves, and from then on covers where it would be some updates later if it kept its course. A call
/// that runs out of memory changes nothing.
class BodyStore {
 public:
  /// The input calls of Broadphase. Boxes that are given again as they are change nothing.
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status move(Pool& pool, std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status remove(std::span<const BodyId> ids);

  /// From now until settle(), up to so many changes of hulls are listed one by one.
  void list_changes(std::size_t most) { most_listed_ = most; }

  /// What has changed and will change until settle() is too much to list.
  void give_up_listing();

  /// No box changed since settle().
  bool is_settled() const { return !moved_ && !too_many_ && changes_.empty(); }

  /// More hulls changed than should be listed.
  bool too_many() const { return too_many_; }

  /// What changed about hulls since settle(), a body once; only when not too_many(). Valid until the next
  /// call of another function.
  std::span<const Change> changes();

  /// Some hull may be larger than its box.
  bool has_slack() const { return slack_; }

  /// Every hull is its box again; for a new start.
  void drop_hulls();

  /// Before hulls() is read for a new start: numbers slots anew where many are free.
  void tidy();

  /// Everything up to now is taken note of.
  void settle();

  /// By slot; NaN where there is no body.
  std::span<const Aabb> boxes() const { return boxes_; }
  Boxes hulls() const { return {hull_data(), boxes_.size()}; }
  const IdTable& table() const { return table_; }

  /// By slot: equal to stamp() when the box has changed since settle().
  const std::uint8_t* stamps() const { return stamps_.data(); }
  std::uint8_t stamp() const { return stamp_; }
  /// At most so many boxes have changed since settle().
  std::size_t fresh() const { return fresh_; }

  std::size_t size() const { return table_.size(); }

  std::size_t bytes() const;

 private:
  using BoxVector = Vector<Aabb>;

  const Aabb* hull_data() const { return slack_ ? hulls_.data() : boxes_.data(); }
  void append(std::span<const BodyId> ids, std::span<const Aabb> boxes);
  Status check_insert(std::span<const BodyId> ids) const;
  Status explain_refusal(std::span<const BodyId> ids, std::span<const Aabb> boxes) const;
  void make_hulls();
  void plan_listing(std::size_t more);
  void put(std::uint32_t slot, const Aabb& box);
  void apply(const MovedBody& body, const Aabb& box);
  void note_change(std::uint32_t slot, bool was, bool is);

  IdTable table_;
  BoxVector boxes_;
  BoxVector hulls_;               // none while all are the boxes themselves
  Vector<std::uint8_t> stamps_;   // by slot: when the box was last changed
  Vector<std::uint32_t> listed_;  // by slot: 1 + the place in changes_, or 0
  Vector<Change> changes_;
  std::size_t most_listed_ = 0;
  bool too_many_ = false;
  bool moved_ = false;
  bool slack_ = false;
  std::uint32_t settled_ = 0;  // how often
  std::uint8_t stamp_ = 1;     // of now
  std::size_t fresh_ = 0;      // boxes that got it, or more
  Vector<MoveCheck> checks_;   // by worker
};

}  // namespace cellsweep::stream
