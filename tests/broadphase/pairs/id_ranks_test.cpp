/// @file
/// Ranks of scattered ids: the order of ids in small numbers.
#include "broadphase/pairs/id_ranks.h"

#include <gmock/gmock.h>

#include <set>
#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using Ids = std::vector<BodyId>;

void insert(IdTable& table, const Ids& ids) {
  Vector<Slot> slots;
  ASSERT_TRUE(table.insert(ids, slots));
}

void remove(IdTable& table, BodyId id) {
  table.reserve_removals(1);
  table.remove(table.find(id));
}

/// Every slot has a rank of its own, and ranks are in the order of ids.
void expect_right(const IdRanks& ranks, const IdTable& table) {
  ASSERT_TRUE(ranks.are_fresh(table));
  std::set<std::uint32_t> all;
  for (Slot slot = 0; slot < table.slot_count(); ++slot) {
    ASSERT_LT(ranks.rank(slot), table.slot_count());
    ASSERT_TRUE(all.insert(ranks.rank(slot)).second);
    ASSERT_EQ(ranks.id(ranks.rank(slot)), table.id(slot));
  }
  for (std::uint32_t rank = 1; rank < table.slot_count(); ++rank)
    ASSERT_LE(ranks.id(rank - 1), ranks.id(rank));
}

TEST(IdRanks, AreInTheOrderOfIds) {
  IdTable table;
  insert(table, {70, 0xffffffff, 0, 5});
  IdRanks ranks;
  EXPECT_FALSE(ranks.are_fresh(table));
  ranks.refresh(table);
  expect_right(ranks, table);
  EXPECT_EQ(ranks.rank(0), 2U);
  EXPECT_EQ(ranks.rank(1), 3U);
  EXPECT_EQ(ranks.rank(2), 0U);
  EXPECT_EQ(ranks.rank(3), 1U);
  EXPECT_GT(ranks.bytes(), 0U);
}

// Few are sorted by comparing, many by their digits.
TEST(IdRanks, AreRightForAnyNumberOfAnyIds) {
  contract::Random random(1);
  for (const std::size_t count : {1, 2, 511, 512, 513, 5000}) {
    for (const std::uint64_t spread :
         {std::uint64_t{1} << 32, std::uint64_t{1} << 22, std::uint64_t{1} << 13}) {
      std::set<BodyId> different;
      while (different.size() < count) different.insert(static_cast<BodyId>(random.below(spread)));
      Ids ids(different.begin(), different.end());
      random.shuffle(ids);
      IdTable table;
      insert(table, ids);
      IdRanks ranks;
      ranks.refresh(table);
      expect_right(ranks, table);
    }
  }
}

TEST(IdRanks, AreFreshUntilBodiesComeOrGo) {
  IdTable table;
  insert(table, {9, 3, 6});
  IdRanks ranks;
  ranks.refresh(table);
  ranks.refresh(table);
  EXPECT_TRUE(ranks.are_fresh(table));
  insert(table, {1});
  EXPECT_FALSE(ranks.are_fresh(table));
  ranks.refresh(table);
  expect_right(ranks, table);
  remove(table, 3);
  EXPECT_FALSE(ranks.are_fresh(table));
  insert(table, {3});
  ranks.refresh(table);
  expect_right(ranks, table);
}

TEST(IdRanks, OfTwoSlotsWithOneIdLieSideBySide) {
  IdTable table;
  insert(table, {9, 3, 6});
  remove(table, 6);
  insert(table, {6});
  IdRanks ranks;
  ranks.refresh(table);
  expect_right(ranks, table);
  EXPECT_EQ(ranks.rank(1), 0U);
  EXPECT_EQ(ranks.rank(0), 3U);
}

TEST(IdRanks, AreNotFreshWhenAllBodiesHaveBeenReplacedByOthers) {
  IdTable table;
  insert(table, {20, 10});
  IdRanks ranks;
  ranks.refresh(table);
  remove(table, 10);
  remove(table, 20);
  table.release();
  insert(table, {5, 7});
  EXPECT_FALSE(ranks.are_fresh(table));
  ranks.refresh(table);
  expect_right(ranks, table);
}

TEST(IdRanks, MayBeAskedForAgainAfterMemoryFailed) {
  contract::Random random(2);
  IdTable table;
  Ids ids(2000);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>(i * 2'000'003);
  random.shuffle(ids);
  insert(table, {3, 1});
  const auto make = [&] {
    IdRanks ranks;
    ranks.refresh(table);
    return ranks;
  };
  IdTable larger;
  insert(larger, {1});
  insert(larger, {2});
  insert(larger, ids);
  const auto refresh = [&](IdRanks& ranks) { ranks.refresh(larger); };
  const auto is_stale = [&](const IdRanks& ranks) { EXPECT_FALSE(ranks.are_fresh(larger)); };
  const auto is_right = [&](const IdRanks& ranks) { expect_right(ranks, larger); };
  EXPECT_EQ(starve(make, refresh, is_stale, is_right), 5U);
}

}  // namespace
}  // namespace cellsweep
