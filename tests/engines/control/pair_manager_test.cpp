#include "engines/control/pair_manager.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>
#include <set>

namespace cellsweep::control {
namespace {

TEST(PairHash, PutsTheSmallerIdInTheLowHalf) {
  EXPECT_EQ(pair_hash(3, 5), 0x00050003);
  EXPECT_EQ(pair_hash(0, 1), 0x00010000);
}

TEST(PairHash, TellsAllPairsApartUpToTheLargestIds) {
  std::set<int> keys;
  for (int a = 65500; a < 65536; ++a) {
    for (int b = a + 1; b < 65536; ++b) keys.insert(pair_hash(a, b));
  }
  EXPECT_EQ(keys.size(), 36U * 35U / 2U);
}

TEST(PairManager, FindsAPairWhicheverIdComesFirst) {
  PairManager pairs;
  pairs.add(7, 2);
  EXPECT_EQ(&pairs.find(2, 7), &pairs.find(7, 2));
  EXPECT_EQ(pairs.find(2, 7).aID, 2);
  EXPECT_EQ(pairs.find(2, 7).bID, 7);
}

TEST(PairManager, EntersPairsAsNotColliding) {
  PairManager pairs;
  pairs.add(0, 1);
  EXPECT_FALSE(pairs.find(0, 1).colliding());
}

TEST(PairManager, CallsAPairCollidingWhenAllThreeAxesOverlap) {
  PairInfo info{0, 1, {true, true, false}};
  EXPECT_FALSE(info.colliding());
  info.value[2] = true;
  EXPECT_TRUE(info.colliding());
}

TEST(PairManager, GivesBackWhatItKnewOfARemovedPair) {
  PairManager pairs;
  pairs.add(0, 1);
  pairs.add(0, 2);
  pairs.find(0, 1).value[1] = true;
  EXPECT_TRUE(pairs.remove(1, 0).value[1]);
  EXPECT_EQ(pairs.size(), 1U);
}

TEST(PairManager, FitsAsManyBodiesAsTheirPairsFill) {
  EXPECT_EQ(bodies_that_fit(kPairMapEntryBytes), 2U);
  EXPECT_EQ(bodies_that_fit(3 * kPairMapEntryBytes), 3U);
  EXPECT_EQ(bodies_that_fit(3 * kPairMapEntryBytes - 1), 2U);
  EXPECT_EQ(bodies_that_fit(std::uint64_t{512} << 20), 4096U);
  EXPECT_EQ(bodies_that_fit(~std::uint64_t{0}), kPairHashIds);
}

// Sanitizers bring allocators of their own, which say nothing through mallinfo2.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if !defined(__has_feature)
TEST(PairManager, CostsTheStatedBytesAnEntry) {
  constexpr int kBodies = 500;
  constexpr double kEntries = kBodies * (kBodies - 1) / 2.0;
  const auto before = mallinfo2().uordblks;
  const auto pairs = std::make_unique<PairManager>();
  for (int larger = 1; larger < kBodies; ++larger) {
    for (int smaller = 0; smaller < larger; ++smaller) pairs->add(smaller, larger);
  }
  const auto bytes = static_cast<double>(mallinfo2().uordblks - before);
  EXPECT_NEAR(bytes / kEntries, static_cast<double>(kPairMapEntryBytes), 1.0);
}
#endif
#endif

TEST(PairManagerCursor, FindsEveryAscendingChoiceOfPairs) {
  PairManager pairs;
  for (int larger = 1; larger < 12; ++larger) {
    for (int smaller = 0; smaller < larger; ++smaller) pairs.add(smaller, larger);
  }
  for (int stride = 1; stride < 70; ++stride) {
    PairManager::Cursor cursor(pairs);
    int number = 0;
    for (int larger = 1; larger < 12; ++larger) {
      for (int smaller = 0; smaller < larger; ++smaller) {
        if (number++ % stride != 0) continue;
        const PairInfo& found = cursor.find(pair_hash(smaller, larger));
        ASSERT_EQ(found.aID, smaller);
        ASSERT_EQ(found.bID, larger);
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::control
