/// @file
/// Blocks in regions: apart from each other, of any thread, and in memory that the next ones find there.
#include "base/memory/regions.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <thread>
#include <vector>

#include "base/memory/pages_there.h"
#include "world/random.h"

#ifdef __linux__

#include <sys/wait.h>
#include <unistd.h>

namespace cellsweep {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;
constexpr std::size_t kHuge = 2 * kMegabyte;

struct Block {
  std::byte* memory;
  std::size_t bytes;
  int mark;
};

Block take_marked(std::size_t bytes, int mark) {
  const Block block{regions::take(bytes), bytes, mark};
  if (block.memory != nullptr) std::memset(block.memory, mark, bytes);
  return block;
}

bool is_as_marked(const Block& block) {
  for (std::size_t i = 0; i < block.bytes; i += 509)
    if (block.memory[i] != static_cast<std::byte>(block.mark)) return false;
  return block.memory[block.bytes - 1] == static_cast<std::byte>(block.mark);
}

void give_all(std::vector<Block>& blocks) {
  for (const Block& block : blocks) EXPECT_TRUE(regions::give(block.memory));
  blocks.clear();
}

TEST(Regions, GiveBlocksOfTheirSizesThatAreAlignedAndMayBeWrittenToTheirEnds) {
  std::vector<Block> blocks;
  for (std::size_t bytes = regions::kLeast; bytes <= regions::kMost; bytes = bytes * 5 / 4 + 1) {
    blocks.push_back(take_marked(bytes, static_cast<int>(blocks.size())));
    const Block& block = blocks.back();
    ASSERT_NE(block.memory, nullptr) << bytes;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.memory) % (bytes < kHuge ? 4096 : kHuge), 0U) << bytes;
  }
  for (const Block& block : blocks) EXPECT_TRUE(is_as_marked(block)) << block.bytes;
  give_all(blocks);
}

TEST(Regions, TakeNothingBackThatIsNotFromThere) {
  std::vector<std::byte> elsewhere(1000);
  EXPECT_FALSE(regions::give(elsewhere.data()));
  EXPECT_FALSE(regions::give(nullptr));
  EXPECT_FALSE(regions::resize(elsewhere.data(), regions::kLeast));
}

TEST(Regions, LetABlockGrowWhereItIsWithWhatIsInIt) {
  const Block first = take_marked(kMegabyte, 7);
  const Block second = take_marked(kMegabyte, 8);
  ASSERT_TRUE(first.memory != nullptr && second.memory != nullptr);
  EXPECT_TRUE(regions::resize(first.memory, kMegabyte / 2));
  EXPECT_TRUE(regions::resize(first.memory, kMegabyte)) << "nobody has the rest of it";
  const Block shorter{first.memory, kMegabyte / 2, 7};
  EXPECT_TRUE(is_as_marked(shorter) && is_as_marked(second));
  EXPECT_TRUE(regions::give(first.memory) && regions::give(second.memory));
}

std::size_t bytes_there(const std::vector<Block>& blocks) {
  std::size_t pages = 0;
  for (const Block& block : blocks) pages += pages_there(block.memory, block.memory + block.bytes);
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// For whoever waits for each page: an engine that is made anew.
TEST(Regions, HaveThePagesOfBlocksThatWereGivenBackForTheNext) {
  std::vector<Block> blocks;
  for (int i = 0; i < 12; ++i) blocks.push_back(take_marked(kMegabyte, i));
  const std::vector<Block> before = blocks;
  give_all(blocks);
  EXPECT_EQ(bytes_there(before), 12 * kMegabyte);
  for (int i = 0; i < 12; ++i) blocks.push_back({regions::take(kMegabyte), kMegabyte, i});
  EXPECT_EQ(bytes_there(blocks), 12 * kMegabyte);
  give_all(blocks);
}

TEST(Regions, LetTheSystemHaveWhatIsMoreThanAFewIdlePages) {
  std::vector<Block> blocks;
  for (int i = 0; i < 40; ++i) blocks.push_back(take_marked(5 * kMegabyte, i));
  EXPECT_EQ(bytes_there(blocks), 200 * kMegabyte);
  for (const Block& block : blocks) EXPECT_TRUE(is_as_marked(block));
  const std::vector<Block> before = blocks;
  give_all(blocks);
  EXPECT_LE(bytes_there(before), regions::kMostIdle);
  blocks.push_back(take_marked(8 * kMegabyte, 3));
  EXPECT_TRUE(is_as_marked(blocks.back())) << "in pages that come again";
  give_all(blocks);
}

void take_and_give(std::uint64_t seed) {
  Random random(seed);
  std::vector<Block> blocks;
  for (int step = 0; step < 400; ++step) {
    if (blocks.size() < 12 && random.below(2) == 0) {
      const std::size_t bytes =
          regions::kLeast + random.below(random.below(6) == 0 ? kHuge + 99'999 : 99'999);
      blocks.push_back(take_marked(bytes, static_cast<int>(random.below(256))));
    } else if (!blocks.empty()) {
      std::swap(blocks[random.below(blocks.size())], blocks.back());
      EXPECT_TRUE(is_as_marked(blocks.back()));
      EXPECT_TRUE(regions::give(blocks.back().memory));
      blocks.pop_back();
    }
  }
  give_all(blocks);
}

TEST(Regions, AreForAnyNumberOfThreads) {
  std::vector<std::thread> threads;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) threads.emplace_back(take_and_give, seed);
  for (std::thread& thread : threads) thread.join();
}

// Whatever another thread does while the process forks.
TEST(Regions, AreThereInAChild) {
  std::atomic<bool> ends = false;
  std::thread other([&] {
    while (!ends) regions::give(regions::take(regions::kLeast));
  });
  for (int i = 0; i < 20; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      std::byte* const memory = regions::take(kMegabyte);
      std::memset(memory, 1, kMegabyte);
      _exit(regions::give(memory) ? 0 : 1);
    }
    int status = 1;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  ends = true;
  other.join();
}

}  // namespace
}  // namespace cellsweep

#endif
