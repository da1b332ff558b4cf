/// @file
/// All that Bodies show, as values to compare.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "broadphase/bodies/bodies.h"

namespace cellsweep {

using Ids = std::vector<BodyId>;

inline const Capacity kAnyNumber = {kSlotMask, "", "of the test"};

/// A box with edge 1 whose lower corner is at (x, 0, 0).
inline Aabb box_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

inline Ids ids_from(BodyId first, std::size_t count) {
  Ids ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// Boxes that all differ.
inline std::vector<Aabb> boxes_from(float x, std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(box_at(x + 2 * static_cast<float>(i)));
  return boxes;
}

/// The bits of a box: -0 is not 0, and nobody's box is nobody's box.
using BoxBits = std::array<std::uint32_t, 6>;

inline BoxBits bits(const Aabb& box) {
  BoxBits result{};
  std::memcpy(result.data(), &box, sizeof box);
  return result;
}

/// What an update would tell: boxes by slot. Bodies that are listed but stay where they are are left out.
struct Shown {
  std::vector<BoxBits> boxes;  ///< now, of all slots
  std::map<Slot, BoxBits> removed;
  std::map<Slot, BoxBits> moved;
  std::vector<Slot> inserted;
  std::size_t bodies = 0;
  std::map<BodyId, Slot> ids;

  friend bool operator==(const Shown&, const Shown&) = default;
};

inline void PrintTo(const Shown& shown, std::ostream* out) {
  *out << shown.bodies << " bodies, " << shown.inserted.size() << " inserted, " << shown.moved.size()
       << " moved, " << shown.removed.size() << " removed, " << shown.boxes.size() << " slots";
}

/// What these changes tell. Expects that no slot is in two lists.
inline Shown shown_in(const BodyChanges& changes, const IdTable& table) {
  Shown shown;
  for (const Aabb& box : changes.boxes) shown.boxes.push_back(bits(box));
  std::vector<int> lists(changes.boxes.size(), 0);
  for (const Slot slot : changes.removed) {
    ++lists[slot];
    shown.removed[slot] = bits(changes.before[slot]);
    EXPECT_EQ(shown.boxes[slot], bits(kNobody));
  }
  for (const Slot slot : changes.moved) {
    ++lists[slot];
    const BoxBits before = bits(changes.before[slot]);
    if (before != shown.boxes[slot]) shown.moved[slot] = before;
  }
  for (const Slot slot : changes.inserted) {
    ++lists[slot];
    shown.inserted.push_back(slot);
  }
  for (const int times : lists) EXPECT_LE(times, 1) << "a slot is in two lists";
  shown.bodies = changes.bodies;
  for (Slot slot = 0; slot < table.slot_count(); ++slot) {
    if (table.find(table.id(slot)) == slot) shown.ids[table.id(slot)] = slot;
  }
  return shown;
}

/// All that a next update would tell, without making one.
inline Shown shown_by(Bodies& bodies) {
  const Shown shown = shown_in(bodies.begin_update(), bodies.table());
  bodies.undo();
  return shown;
}

inline void update(Bodies& bodies) {
  bodies.begin_update();
  bodies.commit();
}

inline Status insert(Crew& crew, Bodies& bodies, const Ids& ids, const std::vector<Aabb>& boxes,
                     const Capacity& capacity = kAnyNumber) {
  return bodies.insert(crew, ids, boxes, {}, "test", capacity);
}

/// By the caller alone.
inline Status insert(Bodies& bodies, const Ids& ids, const std::vector<Aabb>& boxes,
                     const Capacity& capacity = kAnyNumber) {
  Crew caller_alone(nullptr, 1, Crew::Choice::given);
  return bodies.insert(caller_alone, ids, boxes, {}, "test", capacity);
}

/// The box of a body as of the last update; fails the test when it has none.
inline BoxBits box_of(const Bodies& bodies, BodyId id) {
  Aabb box;
  const Status status = bodies.boxes({&id, 1}, {&box, 1});
  EXPECT_TRUE(status.ok()) << status.message;
  return bits(box);
}

}  // namespace cellsweep
