#include "broadphase/bodies/id_table.h"

#include <gmock/gmock.h>

#include <map>
#include <vector>

#include "contract/random.h"

namespace cellsweep::stream {
namespace {

void insert_all(IdTable& table, const std::vector<BodyId>& ids) {
  table.reserve_for(ids);
  for (const BodyId id : ids) table.insert(id);
}

TEST(IdTable, FindsDenseAndSparseIdsThroughInsertsAndRemoves) {
  contract::Random random(1);
  IdTable table;
  std::map<BodyId, std::uint32_t> truth;
  for (int round = 0; round < 3000; ++round) {
    const BodyId id = random.one_in(2) ? static_cast<BodyId>(random.below(300))
                                       : static_cast<BodyId>(random.bits() % 300 * 14'000'000);
    if (const auto held = truth.find(id); held != truth.end()) {
      EXPECT_EQ(table.remove(id), held->second);
      truth.erase(held);
    } else {
      insert_all(table, {id});
      truth[id] = table.find(id);
    }
    if (random.one_in(5)) table.release();
    ASSERT_EQ(table.size(), truth.size());
    ASSERT_EQ(table.find(id), truth.contains(id) ? truth[id] : IdTable::kNone);
  }
  for (const auto& [id, slot] : truth) {
    EXPECT_EQ(table.find(id), slot);
    EXPECT_EQ(table.id(slot), id);
  }
}

TEST(IdTable, KeepsTheSlotOfARemovedBodyUntilRelease) {
  IdTable table;
  insert_all(table, {10, 11, 12});
  const std::uint32_t slot = table.remove(11);
  insert_all(table, {13});
  EXPECT_NE(table.find(13), slot);
  EXPECT_EQ(table.id(slot), 11U);
  table.release();
  insert_all(table, {14});
  EXPECT_EQ(table.find(14), slot);
}

TEST(IdTable, KnowsWhenIdsAreSlots) {
  IdTable table;
  insert_all(table, {0, 1, 2});
  EXPECT_EQ(table.ids(), nullptr);
  EXPECT_TRUE(table.is_plain());
  table.remove(1);
  EXPECT_EQ(table.ids(), nullptr);
  EXPECT_FALSE(table.is_plain());
  insert_all(table, {7});
  EXPECT_NE(table.ids(), nullptr);
}

TEST(IdTable, NumbersSlotsAnewWithoutGaps) {
  IdTable table;
  std::vector<BodyId> ids;
  for (BodyId id = 0; id < 3000; ++id) ids.push_back(3 * id);
  insert_all(table, ids);
  for (const BodyId id : ids) {
    if (id % 30 != 0) table.remove(id);
  }
  EXPECT_TRUE(table.is_sparse());
  const Vector<std::uint32_t> before = table.renumber();
  ASSERT_EQ(before.size(), 300U);
  EXPECT_EQ(table.slot_count(), 300U);
  EXPECT_FALSE(table.is_sparse());
  for (std::uint32_t slot = 0; slot < before.size(); ++slot) {
    EXPECT_EQ(table.id(slot), 3 * before[slot]);
    EXPECT_EQ(table.find(table.id(slot)), slot);
  }
}

}  // namespace
}  // namespace cellsweep::stream
