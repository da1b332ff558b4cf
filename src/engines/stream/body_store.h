/// @file
/// Bodies and boxes of engine `stream`, checked on the way in, and what changed since the last update.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "engines/stream/cell_tree.h"
#include "engines/stream/id_table.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// Every body has two boxes: its own, and a hull around it in which it may move about. Hulls are what the
/// cells hold; while a body stays inside of its hull, no cell changes. A hull is the box itself until the
/// body moves, and from then on covers where it would be some updates later if it kept its course.
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

  /// Before hulls() is read for a new start: numbers slots anew where many are free.
  void tidy();

  /// Everything up to now is taken note of.
  void settle();

  /// By slot; NaN where there is no body.
  std::span<const Aabb> boxes() const { return boxes_; }
  Boxes hulls() const { return {hulls_.data(), nullptr, hulls_.size()}; }
  const IdTable& table() const { return table_; }
  std::size_t size() const { return table_.size(); }

  std::size_t bytes() const;

 private:
  struct Moved {
    std::uint32_t index = 0;  // in the call
    std::uint32_t slot = 0;
    bool escapes = false;  // its hull
  };
  struct Checked {
    bool good = true;
    bool clean = true;  // every box is canonical as it is
    std::vector<Moved> moved;
    std::size_t count = 0;  // of them
    std::size_t escapes = 0;

    std::span<const Moved> view() const { return {moved.data(), count}; }
  };

  void check_moves(std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share, Checked& checked);
  void check_run(std::uint32_t slot, std::span<const Aabb> boxes, Share share, Checked& checked) const;
  void check_some(std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share,
                  Checked& checked) const;
  Status explain_refusal(std::span<const BodyId> ids, std::span<const Aabb> boxes) const;
  void apply(const Moved& body, const Aabb& box);
  void note_change(std::uint32_t slot, bool was, bool is);

  IdTable table_;
  std::vector<Aabb> boxes_;
  std::vector<Aabb> hulls_;
  std::vector<std::uint32_t> listed_;  // by slot: 1 + the place in changes_, or 0
  std::vector<Change> changes_;
  std::size_t most_listed_ = 0;
  bool too_many_ = false;
  bool moved_ = false;
  bool slack_ = false;
  std::uint32_t settled_ = 0;     // how often
  std::vector<Checked> checked_;  // by worker
};

}  // namespace cellsweep::stream
