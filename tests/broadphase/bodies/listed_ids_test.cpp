/// @file
/// Ids of one batch in ascending order.
#include "broadphase/bodies/listed_ids.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using Ids = std::vector<BodyId>;

Ids scattered(std::size_t count) {
  Ids ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<BodyId>(i * 2'654'435'761U);
  return ids;
}

void expect_found(const ListedIds& list, const Ids& ids) {
  for (Slot slot = 0; slot < ids.size(); ++slot) ASSERT_EQ(list.find(ids[slot]), slot);
}

TEST(ListedIds, AreNotThereAtFirst) {
  const ListedIds list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.bytes(), 0U);
  for (const BodyId id : {0U, 1U, 0xffffffffU}) EXPECT_EQ(list.find(id), kNoSlot);
}

TEST(ListedIds, HaveTheSlotsInWhichTheyCame) {
  for (const std::size_t count : {1, 2, 30, 5000}) {
    const Ids ids = scattered(count);
    ListedIds list;
    ASSERT_TRUE(list.list(ids));
    EXPECT_FALSE(list.empty());
    expect_found(list, ids);
    EXPECT_EQ(list.find(1), kNoSlot);
    EXPECT_EQ(list.find(0xffffffff), kNoSlot);
  }
}

TEST(ListedIds, MayBeTheSmallestAndTheLargest) {
  ListedIds list;
  ASSERT_TRUE(list.list(Ids{0xffffffff, 0}));
  expect_found(list, {0xffffffff, 0});
  EXPECT_EQ(list.find(7), kNoSlot);
}

TEST(ListedIds, AreNotListedWhenOneIsThereTwice) {
  Ids ids = scattered(5000);
  ids[4321] = ids[17];
  ListedIds list;
  EXPECT_FALSE(list.list(ids));
  EXPECT_TRUE(list.empty());
  ids[4321] = 5;
  EXPECT_TRUE(list.list(ids));
  expect_found(list, ids);
}

TEST(ListedIds, AreNotListedWithoutMemory) {
  const Ids ids = scattered(5000);
  const auto places = starve([] { return ListedIds(); }, [&](ListedIds& list) { list.list(ids); },
                             [](const ListedIds& list) { EXPECT_TRUE(list.empty()); },
                             [&](const ListedIds& list) { expect_found(list, ids); });
  EXPECT_GE(places, 2U);
}

}  // namespace
}  // namespace cellsweep
