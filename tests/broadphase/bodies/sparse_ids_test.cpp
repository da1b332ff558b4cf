/// @file
/// Ids that lie anywhere, in a table of open addresses.
#include "broadphase/bodies/sparse_ids.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

TEST(SparseIds, AreNotThereAtFirst) {
  const SparseIds ids;
  EXPECT_EQ(ids.size(), 0U);
  EXPECT_EQ(ids.bytes(), 0U);
  for (const BodyId id : {0U, 1U, 0xffffffffU}) {
    EXPECT_EQ(ids.find(id), kNoSlot);
    ids.prefetch(id);
  }
}

TEST(SparseIds, AreFoundWhateverCameAndWent) {
  contract::Random random(1);
  SparseIds ids;
  std::map<BodyId, Slot> truth;
  for (Slot step = 0; step < 20'000; ++step) {
    const auto id = static_cast<BodyId>(random.below(500) * 8'606'713);
    const auto held = truth.find(id);
    ASSERT_EQ(ids.find(id), held == truth.end() ? kNoSlot : held->second);
    if (held == truth.end()) {
      ids.reserve(ids.size() + 1);
      ASSERT_TRUE(ids.insert(id, step));
      truth[id] = step;
    } else {
      ASSERT_FALSE(ids.insert(id, step));
      ids.erase(id);
      truth.erase(held);
    }
    ASSERT_EQ(ids.size(), truth.size());
  }
  for (const auto& [id, slot] : truth) EXPECT_EQ(ids.find(id), slot);
}

TEST(SparseIds, MayBeTheSmallestAndTheLargest) {
  SparseIds ids;
  ids.reserve(2);
  EXPECT_TRUE(ids.insert(0xffffffff, 0));
  EXPECT_TRUE(ids.insert(0, kSlotMask));
  EXPECT_EQ(ids.find(0xffffffff), 0U);
  EXPECT_EQ(ids.find(0), kSlotMask);
  ids.erase(0);
  EXPECT_EQ(ids.find(0), kNoSlot);
  EXPECT_EQ(ids.find(0xffffffff), 0U);
}

constexpr std::uint64_t kKey = 0x1234567;

/// Ids that a table of this size and key would all put into one place.
std::vector<BodyId> ids_of_home(std::size_t home, std::size_t count, std::uint64_t key = kKey,
                                std::size_t entries = 64) {
  std::vector<BodyId> ids;
  for (BodyId id = 0; ids.size() < count; ++id) {
    if (mix64(id ^ key) % entries == home) ids.push_back(id);
  }
  return ids;
}

// Places from the end of the table on, and from its beginning: those at the end go on there.
TEST(SparseIds, ThatWantTheSamePlaceAreFoundAfterAnyOfThemHasGone) {
  for (const std::size_t home : {0, 30, 62, 63}) {
    std::vector<BodyId> all = ids_of_home(home, 6);
    const std::vector<BodyId> neighbours = ids_of_home((home + 2) % 64, 4);
    all.insert(all.begin() + 3, neighbours.begin(), neighbours.end());
    for (std::size_t first_gone = 0; first_gone < all.size(); ++first_gone) {
      SparseIds ids(kKey);
      ids.reserve(all.size());
      for (Slot i = 0; i < all.size(); ++i) ASSERT_TRUE(ids.insert(all[i], i));
      for (std::size_t gone = 0; gone < all.size(); ++gone) {
        for (std::size_t i = 0; i < all.size(); ++i) {
          const bool is_gone = (i + all.size() - first_gone) % all.size() < gone;
          ASSERT_EQ(ids.find(all[i]), is_gone ? kNoSlot : i) << "home " << home << ", " << gone << " gone";
        }
        ids.erase(all[(first_gone + gone) % all.size()]);
      }
      EXPECT_EQ(ids.size(), 0U);
    }
  }
}

/// How far from its place the farthest of these is.
std::size_t longest_way(SparseIds ids, const std::vector<BodyId>& chosen) {
  ids.reserve(chosen.size());
  EXPECT_EQ(ids.insert_run(chosen, 0), chosen.size());
  return ids.longest_way();
}

// Half of the table is free: the way is a few logarithms long.
TEST(SparseIds, CannotBeChosenSoThatAllWantOnePlace) {
  const std::vector<BodyId> chosen = ids_of_home(7, 2000, kKey, 4096);
  EXPECT_EQ(longest_way(SparseIds(kKey), chosen), 1999U) << "by somebody who knows the key";
  for (int table = 0; table < 20; ++table) EXPECT_LE(longest_way(SparseIds(), chosen), 200U);
}

TEST(SparseIds, HaveAKeyOfTheirOwnInEachTable) {
  const std::uint64_t key = unforeseen_key();
  EXPECT_NE(key, 0U);
  EXPECT_NE(key, unforeseen_key());
}

TEST(SparseIds, ThatWereChosenAreFoundAndTakenOutAsQuickly) {
  std::vector<BodyId> chosen = ids_of_home(7, 2000, 0, 4096);
  SparseIds ids;
  for (Slot i = 0; i < chosen.size(); ++i) {
    ids.reserve(i + 1);
    ASSERT_TRUE(ids.insert(chosen[i], i));
    ASSERT_LE(ids.longest_way(), 200U);
  }
  for (Slot i = 0; i < chosen.size(); ++i) {
    ASSERT_EQ(ids.find(chosen[i]), i);
    if (i % 3 == 0) ids.erase(chosen[i]);
    ASSERT_LE(ids.longest_way(), 200U);
  }
}

TEST(SparseIds, HaveRoomForAsManyAsWereAskedFor) {
  SparseIds ids;
  ids.reserve(1000);
  const std::size_t bytes = ids.bytes();
  for (BodyId id = 0; id < 1000; ++id) ASSERT_TRUE(ids.insert(~id, id));
  EXPECT_EQ(ids.bytes(), bytes);
  EXPECT_LE(bytes, 32U * 1024);
}

TEST(SparseIds, AreAllThereWhenMemoryForMoreFailed) {
  SparseIds ids;
  ids.reserve(10);
  for (BodyId id = 0; id < 10; ++id) ASSERT_TRUE(ids.insert(id * 1'000'003, id));
  EXPECT_TRUE(fails_at(1, [&] { ids.reserve(10'000); }));
  for (BodyId id = 0; id < 10; ++id) EXPECT_EQ(ids.find(id * 1'000'003), id);
  ids.reserve(10'000);
  for (BodyId id = 0; id < 10; ++id) EXPECT_EQ(ids.find(id * 1'000'003), id);
}

}  // namespace
}  // namespace cellsweep
