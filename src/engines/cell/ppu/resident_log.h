/// @file
/// What happened to bodies since the SPUs were told last, with later calls folded into earlier ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/body_table.h"
#include "cellsweep/aabb.h"

namespace cellsweep::cell {

/// Three lists, to be told in this order: slots whose body is gone, moved bodies, new bodies. A slot may be
/// in the first and the last: its body went and another came. A body that came and went unseen is in none.
class ResidentLog {
 public:
  void insert(Slot slot, const Aabb& box);
  void move(Slot slot, const Aabb& box);
  void remove(Slot slot);

  bool empty() const { return removed_.empty() && moved_.empty() && inserted_.empty(); }

  std::span<const Slot> removed() const { return removed_; }
  /// A body may be listed more than once (the SPUs drop duplicates).
  std::span<const Slot> moved() const { return moved_; }
  std::span<const Slot> inserted() const { return inserted_; }

  /// The body's latest box.
  const Aabb& box(Slot slot) const { return boxes_[slot]; }

  /// All has been told.
  void clear();

 private:
  enum class State : std::uint8_t { empty, known, inserted };

  void make_room(Slot slot);

  std::vector<Aabb> boxes_;   // by slot
  std::vector<State> state_;  // by slot: how the SPUs will know it when all is told
  std::vector<Slot> removed_;
  std::vector<Slot> moved_;
  std::vector<Slot> inserted_;
};

}  // namespace cellsweep::cell
