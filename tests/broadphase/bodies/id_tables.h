/// @file
/// Tables of ids, for their tests.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "broadphase/bodies/id_table.h"
#include "contract/random.h"

namespace cellsweep {

using Ids = std::vector<BodyId>;

/// The slots that the ids got; fails the test when they were refused.
inline std::vector<Slot> insert(IdTable& table, const Ids& ids) {
  List<Slot> slots;
  EXPECT_TRUE(table.insert(ids, slots));
  return {slots.begin(), slots.end()};
}

inline void remove(IdTable& table, const Ids& ids) {
  table.reserve_removals(ids.size());
  for (const BodyId id : ids) table.remove(table.find(id));
}

inline IdTable table_of(const Ids& ids) {
  IdTable table;
  insert(table, ids);
  return table;
}

/// One of every neighbourhood.
inline BodyId random_id(contract::Random& random) {
  constexpr BodyId kSpecial[] = {0, 1, 0xffffffff, 0xfffffffe, 1023, 1024, 1025};
  if (random.one_in(3)) return static_cast<BodyId>(random.below(300));
  if (random.one_in(5)) return kSpecial[random.below(7)];
  return static_cast<BodyId>(random.below(300) * 14'000'029);
}

}  // namespace cellsweep
