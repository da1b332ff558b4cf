/// @file
/// Keys that grow as kernels write them, up to as many as there may be.
#include "engines/stream/cells/keys.h"

#include <gmock/gmock.h>

#include <vector>

#include "base/memory/starved.h"

namespace cellsweep::stream {
namespace {

void add(Keys& keys, std::uint64_t key) {
  KeyBuffer& buffer = keys.buffer();
  make_room(buffer, 1);
  buffer.keys[buffer.size++] = key;
}

void add(Keys& keys, std::uint64_t first, std::uint64_t end) {
  for (std::uint64_t key = first; key < end; ++key) add(keys, key);
}

void expect_numbers_below(const Keys& keys, std::uint64_t end) {
  ASSERT_EQ(keys.view().size(), end);
  for (std::uint64_t key = 0; key < end; ++key) ASSERT_EQ(keys.view()[key], key);
}

TEST(Keys, AreNoneAtFirst) {
  Keys keys;
  EXPECT_TRUE(keys.view().empty());
  keys.clear();
  EXPECT_TRUE(keys.view().empty());
}

TEST(Keys, KeepTheirOrderWhileTheyGrow) {
  Keys keys;
  add(keys, 0, 100'000);
  expect_numbers_below(keys, 100'000);
}

// Of a thousand bodies that all overlap, ten are not static.
TEST(Keys, TakeNoMemoryForPairsThatFiltersDoNotAllow) {
  constexpr Slot kBodies = 1000;
  std::vector<BodyFilter> filters(kBodies, BodyFilter{.is_static = true});
  for (Slot slot = 0; slot < kBodies; slot += 100) filters[slot].is_static = false;
  Keys keys;
  keys.allow(filters);
  std::vector<std::uint64_t> expected;
  for (Slot one = 0; one < kBodies; ++one) {
    for (Slot other = one + 1; other < kBodies; ++other) {
      add(keys, pair_key(SlotPair{one, other}));
      if (one % 100 == 0 || other % 100 == 0) expected.push_back(pair_key(SlotPair{one, other}));
    }
  }
  keys.leave_out();
  EXPECT_THAT(keys.view(), testing::ElementsAreArray(expected));
  EXPECT_LE(keys.bytes(), 4 * sizeof(std::uint64_t) * (expected.size() + 1000));
  keys.allow({});
  add(keys, pair_key(SlotPair{1, 2}));
  keys.leave_out();
  EXPECT_EQ(keys.view().size(), expected.size() + 1) << "all are allowed again";
}

TEST(Keys, OfMarkedSlotsAreLeftOutAndOthersTakeTheirPlace) {
  std::vector<std::uint8_t> marked(100, 0);
  for (Slot slot = 0; slot < 100; slot += 7) marked[slot] = 1;
  Keys keys;
  std::vector<std::uint64_t> expected;
  for (Slot one = 0; one < 100; ++one) {
    for (Slot other = one + 1; other < 100; other += 3) {
      add(keys, pair_key(SlotPair{one, other}));
      if (one % 7 != 0 && other % 7 != 0) expected.push_back(pair_key(SlotPair{one, other}));
    }
  }
  keys.leave_out(marked.data());
  EXPECT_THAT(keys.view(), testing::ElementsAreArray(expected));
  const std::vector<std::uint64_t> more(5000, pair_key(SlotPair{7, 14}));
  keys.append(more);
  keys.append({});
  expected.insert(expected.end(), more.begin(), more.end());
  EXPECT_THAT(keys.view(), testing::ElementsAreArray(expected));
}

TEST(Keys, CountAgainstTheLimitWhenFiltersAllowThem) {
  const std::vector<BodyFilter> filters(3000, BodyFilter{.mask = 0});
  Keys keys;
  keys.allow(filters);
  keys.buffer().most = 10;
  add(keys, 0, 2500);
  keys.leave_out();
  EXPECT_TRUE(keys.view().empty());
  keys.allow({});
  EXPECT_THROW(add(keys, 0, 5000), TooManyPairs);
}

TEST(Keys, HaveRoomForAsManyAsAreAskedForAtATime) {
  Keys keys;
  add(keys, 0);
  make_room(keys.buffer(), 50'000);
  EXPECT_GE(keys.buffer().capacity - keys.buffer().size, 50'000U);
  expect_numbers_below(keys, 1);
}

TEST(Keys, KeepTheirRoomWhenTheyAreClearedAndMostOfItWasUsed) {
  Keys keys;
  add(keys, 0, 50'000);
  const std::size_t capacity = keys.buffer().capacity;
  keys.clear();
  EXPECT_TRUE(keys.view().empty());
  EXPECT_EQ(keys.buffer().capacity, capacity);
  add(keys, 0, 100);
  keys.clear();
  EXPECT_EQ(keys.buffer().capacity, 0U) << "of which little was used the second time";
  add(keys, 0, 100);
  keys.clear();
  EXPECT_GT(keys.buffer().capacity, 0U) << "little room is kept whatever it was used for";
  add(keys, 0, 10);
  expect_numbers_below(keys, 10);
}

TEST(Keys, GrowNoMoreWhenThereAreMoreThanThereMayBe) {
  Keys keys;
  keys.buffer().most = 5000;
  EXPECT_THROW(add(keys, 0, 1'000'000), TooManyPairs);
  const std::size_t size = keys.view().size();
  EXPECT_GT(size, 5000U) << "as many as there may be are fine";
  EXPECT_LT(size, 20'000U);
  keys.clear();
  add(keys, 0, 5000);
  expect_numbers_below(keys, 5000);
}

TEST(Keys, AreAllThereWhenMemoryForMoreFailed) {
  Keys keys;
  add(keys, 0, 500);
  EXPECT_TRUE(fails_at(1, [&] { make_room(keys.buffer(), 100'000); }));
  expect_numbers_below(keys, 500);
  add(keys, 500, 50'000);
  expect_numbers_below(keys, 50'000);
}

}  // namespace
}  // namespace cellsweep::stream
