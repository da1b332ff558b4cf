/// @file
/// Ids to slots and back.
#include "broadphase/body_table.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "contract/random.h"

namespace cellsweep {
namespace {

TEST(BodyTable, ANewTableIsEmpty) {
  const BodyTable table;
  EXPECT_EQ(table.size(), 0U);
  EXPECT_EQ(table.slot_count(), 0U);
  EXPECT_EQ(table.find(0), kNoSlot);
}

TEST(BodyTable, SlotsAreGivenOutInOrder) {
  BodyTable table;
  EXPECT_EQ(table.insert(700), 0U);
  EXPECT_EQ(table.insert(0xffffffff), 1U);
  EXPECT_EQ(table.insert(0), 2U);
  EXPECT_EQ(table.find(700), 0U);
  EXPECT_EQ(table.find(0xffffffff), 1U);
  EXPECT_EQ(table.find(0), 2U);
  EXPECT_EQ(table.id(1), 0xffffffffU);
  EXPECT_EQ(table.size(), 3U);
  EXPECT_EQ(table.slot_count(), 3U);
}

TEST(BodyTable, TheSlotFreedLastIsUsedFirst) {
  BodyTable table;
  for (BodyId id = 10; id < 14; ++id) table.insert(id);
  EXPECT_EQ(table.remove(11), 1U);
  EXPECT_EQ(table.remove(13), 3U);
  EXPECT_EQ(table.size(), 2U);
  EXPECT_EQ(table.slot_count(), 4U);
  EXPECT_EQ(table.insert(20), 3U);
  EXPECT_EQ(table.insert(21), 1U);
  EXPECT_EQ(table.insert(22), 4U);
  EXPECT_EQ(table.id(3), 20U);
}

TEST(BodyTable, ARemovedBodyIsNotFoundButItsSlotRemembersIt) {
  BodyTable table;
  table.insert(5);
  table.insert(6);
  EXPECT_EQ(table.remove(5), 0U);
  EXPECT_EQ(table.find(5), kNoSlot);
  EXPECT_EQ(table.id(0), 5U);
  EXPECT_EQ(table.find(6), 1U);
}

TEST(BodyTable, MakingRoomChangesNothing) {
  BodyTable table;
  table.insert(9);
  table.reserve_more(1000);
  EXPECT_EQ(table.size(), 1U);
  EXPECT_EQ(table.slot_count(), 1U);
  EXPECT_EQ(table.find(9), 0U);
}

/// Every body of `slots` is found where it was put, and no two share a slot.
void expect_same(const BodyTable& table, const std::map<BodyId, Slot>& slots) {
  ASSERT_EQ(table.size(), slots.size());
  std::set<Slot> used;
  for (const auto& [id, slot] : slots) {
    ASSERT_EQ(table.find(id), slot);
    ASSERT_EQ(table.id(slot), id);
    ASSERT_LT(slot, table.slot_count());
    ASSERT_TRUE(used.insert(slot).second);
  }
}

TEST(BodyTable, AgreesWithAMapOverThousandsOfRandomCalls) {
  contract::Random random(3);
  BodyTable table;
  std::map<BodyId, Slot> slots;
  std::size_t most = 0;
  for (int call = 0; call < 3000; ++call) {
    const auto id = static_cast<BodyId>(random.below(60) * 0x04000001);
    if (const auto found = slots.find(id); found != slots.end()) {
      ASSERT_EQ(table.remove(id), found->second);
      slots.erase(found);
    } else {
      if (random.one_in(3)) table.reserve_more(random.below(5));
      slots[id] = table.insert(id);
    }
    most = std::max(most, slots.size());
    expect_same(table, slots);
    ASSERT_EQ(table.slot_count(), most) << "a free slot was left unused";
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace cellsweep
