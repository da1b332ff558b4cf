/// @file
/// Memory that is given out piece by piece and taken back all at once.
#include "base/memory/arena.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/starved.h"

namespace cellsweep {
namespace {

TEST(Arena, HandsOutAlignedBlocksThatDoNotOverlap) {
  Arena arena;
  std::vector<std::uint32_t*> blocks;
  for (std::uint32_t i = 0; i < 200; ++i) {
    auto* block = arena.take<std::uint32_t>(1 + i * 37);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 64, 0U);
    std::fill_n(block, 1 + i * 37, i);
    blocks.push_back(block);
  }
  for (std::uint32_t i = 0; i < blocks.size(); ++i) {
    EXPECT_TRUE(
        std::all_of(blocks[i], blocks[i] + 1 + i * 37, [&](std::uint32_t value) { return value == i; }));
  }
}

TEST(Arena, TakesBlocksBackToAMark) {
  Arena arena;
  arena.take<char>(100);
  const Arena::Mark mark = arena.mark();
  char* first = arena.take<char>(50);
  for (int i = 0; i < 100; ++i) arena.take<char>(50'000);
  arena.release(mark);
  EXPECT_EQ(arena.take<char>(50), first);
}

TEST(Arena, KeepsWhatTheLastRoundNeededAndNoMore) {
  Arena arena;
  for (int i = 0; i < 100; ++i) arena.take<char>(100'000);
  const std::size_t much = arena.bytes();
  EXPECT_GE(much, 10'000'000U);
  arena.reset(much);
  EXPECT_EQ(arena.bytes(), much);
  arena.take<char>(1000);
  arena.reset(much);
  EXPECT_LT(arena.bytes(), much / 10);
}

TEST(Arena, KeepsNoMoreThanItIsTold) {
  Arena arena;
  for (int i = 0; i < 100; ++i) arena.take<char>(100'000);
  arena.reset(1'000'000);
  EXPECT_LT(arena.bytes(), 2'000'000U);
}

TEST(Arena, HoldsLittleMoreThanItHandsOut) {
  constexpr std::size_t kBlock = 4096;
  for (const std::size_t all : {100'000, 700'000, 1'400'000, 3'000'000, 7'000'000, 30'000'000}) {
    Arena arena;
    for (std::size_t handed_out = 0; handed_out < all; handed_out += kBlock) arena.take<char>(kBlock);
    const std::size_t least_step = all < kHugePage ? all / 10 : kHugePage;
    EXPECT_LE(arena.bytes(), all + all / 4 + least_step) << all;
  }
}

TEST(Arena, HasRoomForSmallBlocksBehindALargeOne) {
  Arena arena;
  arena.take<char>(1'000'000);
  const std::size_t before = arena.bytes();
  for (int i = 0; i < 20; ++i) arena.take<char>(5000);
  EXPECT_EQ(arena.bytes(), before);
}

TEST(Arena, HasRoomForABlockLargerThanAllBefore) {
  Arena arena;
  for (std::size_t size = 1; size < 10'000'000; size *= 3) {
    char* block = arena.take<char>(size);
    block[0] = block[size - 1] = 1;
    if (size % 2 == 0) arena.release({});
  }
  EXPECT_GE(arena.bytes(), 4'000'000U);
}

TEST(Arena, TakesBackInItsScopeWhatWasHandedOutInIt) {
  Arena arena;
  char* first = nullptr;
  for (int round = 0; round < 3; ++round) {
    const ArenaScope scope(arena);
    char* const block = arena.take<char>(200'000);
    if (round == 0) first = block;
    EXPECT_EQ(block, first);
    const ArenaScope inner(arena);
    arena.take<char>(300'000);
  }
}

TEST(Arena, FitsWhatItHandedOut) {
  for (const std::size_t all : {1000, 60'000, 300'000, 1'400'000, 3'000'000, 20'000'000}) {
    Arena arena;
    std::vector<std::span<char>> blocks;
    const auto take = [&] {
      blocks.emplace_back(arena.take<char>(1000), 1000);
      std::fill(blocks.back().begin(), blocks.back().end(), static_cast<char>(blocks.size()));
    };
    while (1024 * blocks.size() < all) take();
    const Arena::Mark mark = arena.mark();
    arena.take<char>(10'000'000);
    arena.release(mark);
    const std::size_t before = arena.bytes();
    arena.fit();
    EXPECT_LE(arena.bytes(), before - 10'000'000);
#ifdef __linux__
    EXPECT_LE(arena.bytes(), 1024 * blocks.size() + all / 4 + 8192) << all;
#endif
    for (int i = 0; i < 300; ++i) take();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      ASSERT_EQ(std::ranges::count(blocks[i], static_cast<char>(i + 1)), 1000) << all << ", block " << i;
    }
    EXPECT_GE(arena.bytes(), 1024 * blocks.size());
  }
}

TEST(Arena, FitsNothing) {
  Arena arena;
  arena.fit();
  arena.take<char>(100);
  arena.release({});
  arena.fit();
  EXPECT_EQ(arena.bytes(), 0U);
  std::fill_n(arena.take<char>(100), 100, 'a');
  EXPECT_GE(arena.bytes(), 100U);
}

TEST(Arena, GoesOnAfterMemoryFailed) {
  Arena arena;
  char* const kept = arena.take<char>(1000);
  std::fill_n(kept, 1000, 'k');
  const std::size_t bytes = arena.bytes();
  for (int round = 0; round < 3; ++round) {
    EXPECT_TRUE(fails_at(1, [&] { arena.take<char>(500'000); }));
    EXPECT_EQ(arena.bytes(), bytes);
  }
  char* const block = arena.take<char>(500'000);
  std::fill_n(block, 500'000, 'b');
  EXPECT_TRUE(std::all_of(kept, kept + 1000, [](char value) { return value == 'k'; }));
  EXPECT_GE(arena.bytes(), 501'000U);
  EXPECT_TRUE(fails_at(1, [&] {
    Arena empty;
    empty.take<char>(1);
  }));
}

}  // namespace
}  // namespace cellsweep
