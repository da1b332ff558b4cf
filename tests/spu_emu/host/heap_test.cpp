// The heap of the local store.
#include "host/heap.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace spu_emu {
namespace {

TEST(Heap, aligns_blocks_and_takes_the_lowest_place) {
  Heap heap;
  heap.reset(0x108, 0x1000);
  EXPECT_EQ(heap.allocate(1, 1), 0x110U);
  EXPECT_EQ(heap.allocate(100, 128), 0x180U);
  EXPECT_EQ(heap.allocate(16, 16), 0x130U);
  EXPECT_TRUE(heap.release(0x110));
  EXPECT_EQ(heap.allocate(16, 16), 0x110U);
  EXPECT_FALSE(heap.release(0x111));
  EXPECT_EQ(heap.size_of(0x180), 112U);
  EXPECT_EQ(heap.size_of(0x181), 0U);
}

TEST(Heap, says_when_nothing_fits_and_counts_the_high_water) {
  Heap heap;
  heap.reset(0, 1024);
  EXPECT_EQ(heap.allocate(1024, 16), 0U);
  EXPECT_FALSE(heap.allocate(1, 16).has_value());
  EXPECT_FALSE(heap.allocate(SIZE_MAX, 16).has_value());
  EXPECT_TRUE(heap.release(0));
  EXPECT_EQ(heap.in_use(), 0U);
  EXPECT_EQ(heap.high_water(), 1024U);
  EXPECT_EQ(heap.free_bytes(), 1024U);
  heap.allocate(16, 16);
  EXPECT_EQ(heap.largest_free(), 1008U);
}

TEST(Heap, keeps_guards_behind_blocks_while_there_is_room) {
  Heap heap;
  heap.reset(0, 256);
  EXPECT_EQ(heap.allocate(100, 16), 0U);
  EXPECT_EQ(heap.allocate(16, 16), 128U);
  const auto guard = heap.guard_of(0);
  ASSERT_TRUE(guard.has_value());
  EXPECT_EQ(guard->asked, 100U);
  EXPECT_EQ(guard->first, 112U);
  EXPECT_FALSE(heap.guard_of(16).has_value());
  EXPECT_EQ(heap.guards().size(), 2U);
  EXPECT_EQ(heap.free_bytes(), 128U);
  EXPECT_EQ(heap.allocate(112, 16), 144U) << "the guards have given way";
  EXPECT_TRUE(heap.guards().empty());
  EXPECT_EQ(heap.allocate(16, 16), 112U);
  EXPECT_EQ(heap.free_bytes(), 0U);
}

TEST(Heap, random_use_never_overlaps_and_never_loses_bytes) {
  Heap heap;
  heap.reset(0x4000, 0x10000);
  std::map<std::uint32_t, std::uint32_t> blocks;
  std::mt19937 random(3);
  for (int step = 0; step < 20000; ++step) {
    if (random() % 2 == 0 && !blocks.empty()) {
      const auto victim = std::next(blocks.begin(), static_cast<std::ptrdiff_t>(random() % blocks.size()));
      ASSERT_TRUE(heap.release(victim->first));
      blocks.erase(victim);
      continue;
    }
    const std::uint32_t size = 1 + random() % 2000;
    const std::uint32_t alignment = 16U << (random() % 5);
    const auto ls = heap.allocate(size, alignment);
    if (!ls) continue;
    ASSERT_EQ(*ls % alignment, 0U);
    const auto after = blocks.lower_bound(*ls);
    ASSERT_TRUE(after == blocks.end() || *ls + size <= after->first);
    ASSERT_TRUE(after == blocks.begin() || std::prev(after)->first + std::prev(after)->second <= *ls);
    blocks[*ls] = heap.size_of(*ls);
  }
  std::uint32_t used = 0;
  for (const auto& [ls, size] : blocks) used += size;
  EXPECT_EQ(heap.in_use(), used);
}

}  // namespace
}  // namespace spu_emu
