/// @file
/// Blocks of memory: aligned, growing, given back, and none when a test says so.
#include "base/memory/memory.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "base/memory/pages_there.h"
#include "base/memory/starved.h"

namespace cellsweep {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

std::size_t address(const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory);
}

/// False when there is no memory.
bool takes_some() {
  try {
    give_memory(take_memory(100));
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

TEST(Memory, BlocksOfEverySizeAreAlignedAndMayBeWrittenToTheirEnds) {
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{65}, std::size_t{4097},
        kHugePage - 1, kHugePage, kHugePage + 1, 20 * kHugePage + 5}) {
    for (const std::size_t alignment : {std::size_t{1}, alignof(std::max_align_t), kMemoryAlignment}) {
      const Memory<std::byte> memory(take_memory(size, alignment));
      ASSERT_NE(memory.get(), nullptr);
      EXPECT_EQ(address(memory.get()) % std::max(alignment, alignof(std::max_align_t)), 0U) << size;
      EXPECT_TRUE(size < kHugePage || address(memory.get()) % kHugePage == 0) << size;
      std::memset(memory.get(), 0xa5, size);
    }
  }
}

TEST(Memory, BlocksThatAreReadHereAndThereAreAlignedAndFailAsOthersDo) {
  for (const std::size_t size : {std::size_t{1}, kHugePage - 1, 40 * kHugePage + 5}) {
    const Memory<std::byte> memory(take_huge_pages(size, kMemoryAlignment));
    EXPECT_EQ(address(memory.get()) % (size < kHugePage ? kMemoryAlignment : kHugePage), 0U) << size;
    std::memset(memory.get(), 0xa5, size);
    let_memory_fail(1);
    EXPECT_THROW(take_huge_pages(size), std::bad_alloc);
  }
}

#ifdef __linux__

/// What the system says of the mapping that a block is in: its flags.
std::string flags_of(const void* memory) {
  std::ifstream mappings("/proc/self/smaps");
  bool is_here = false;
  for (std::string line; std::getline(mappings, line);) {
    std::size_t begin = 0;
    std::size_t end = 0;
    if (std::sscanf(line.c_str(), "%zx-%zx ", &begin, &end) == 2)
      is_here = begin <= address(memory) && address(memory) < end;
    if (is_here && line.starts_with("VmFlags:")) return line + " ";
  }
  return {};
}

// Flag hg: memory for which huge pages were asked. A system that has none has no such flag either.
TEST(Memory, OnlyWhatIsReadHereAndThereAsksForHugePagesWhateverItsSize) {
  const Memory<std::byte> some(take_memory(2 * kHugePage));
  if (flags_of(some.get()).find(" hg ") == std::string::npos) GTEST_SKIP() << "this system has no huge pages";
  const Memory<std::byte> large(take_memory(20 * kHugePage));
  EXPECT_EQ(flags_of(large.get()).find(" hg "), std::string::npos);
  const Memory<std::byte> read_here_and_there(take_huge_pages(20 * kHugePage));
  EXPECT_NE(flags_of(read_here_and_there.get()).find(" hg "), std::string::npos);
}

#endif

TEST(Memory, AGrownBlockBeginsWithWhatWasInIt) {
  std::byte* memory = grow_memory(nullptr, 0, 3);
  std::memcpy(memory, "abc", 3);
  std::size_t held = 3;
  for (std::size_t size = 4; size < 30 * kHugePage; held = size, size = 3 * size + 1) {
    memory = grow_memory(memory, held, size);
    EXPECT_EQ(std::memcmp(memory, "abc", 3), 0) << size;
    EXPECT_TRUE(
        std::all_of(memory + 3, memory + held, [](std::byte value) { return value == std::byte{7}; }));
    std::memset(memory + 3, 7, size - 3);
  }
  give_grown(memory, held);
}

TEST(Memory, OfAnySizeGrowsFromNothing) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kHugePage, 4 * kHugePage - 1, 4 * kHugePage,
                                 4 * kHugePage + 1, 20 * kHugePage + 5}) {
    std::byte* const memory = grow_memory(nullptr, 0, size);
    ASSERT_NE(memory, nullptr) << size;
    std::memset(memory, 0xa5, size);
    give_grown(memory, size);
  }
}

TEST(Memory, OfNothingIsGivenBackToo) {
  give_memory(nullptr);
}

TEST(Memory, FailsTheTimeThatATestAsksForAndOnce) {
  const auto take = [] { give_memory(take_memory(100)); };
  const FailingMemory memory(3);
  take();
  take();
  EXPECT_THROW(take(), std::bad_alloc);
  take();
  take();
}

TEST(Memory, FailsNoMoreWhenATestSaysSo) {
  let_memory_fail(1);
  let_memory_fail(0);
  give_memory(take_memory(100));
}

TEST(Memory, ABlockThatCannotGrowIsAsItWas) {
  Memory<std::byte> memory(take_memory(100));
  std::memset(memory.get(), 7, 100);
  {
    const FailingMemory failing(1);
    EXPECT_THROW(grow_memory(memory.get(), 100, 1000), std::bad_alloc);
  }
  {
    const FailingMemory failing(1);
    EXPECT_THROW(grow_memory(memory.get(), 100, 20 * kHugePage), std::bad_alloc);
  }
  EXPECT_TRUE(
      std::all_of(memory.get(), memory.get() + 100, [](std::byte value) { return value == std::byte{7}; }));
}

#ifdef __linux__

TEST(Memory, OfABlockIsGivenBackBehindItsFirstBytes) {
  for (const std::size_t size : {std::size_t{100'000}, kHugePage, 5 * kHugePage}) {
    const Memory<std::byte> memory(take_memory(size));
    std::memset(memory.get(), 7, size);
    ASSERT_GT(pages_there(memory.get(), memory.get() + size), 20U);
    const std::size_t held = shrink_memory(memory.get(), size, 50'000);
    EXPECT_GE(held, 50'000U);
    EXPECT_LT(held, 60'000U);
    EXPECT_EQ(pages_there(memory.get() + held, memory.get() + size), 0U);
    EXPECT_EQ(std::count(memory.get(), memory.get() + 50'000, std::byte{7}), 50'000);
    EXPECT_EQ(shrink_memory(memory.get(), held, held), held) << "there is nothing left to give";
  }
}

#if !defined(CELLSWEEP_SANITIZED_TESTS)
// Else an engine that is made anew waits for each page again.
TEST(Memory, OfMiddleSizeHasThePagesOfWhatWasGivenBack) {
  for (const std::size_t size : {std::size_t{70'000}, std::size_t{1'000'000}, 3 * kHugePage}) {
    std::memset(Memory<std::byte>(take_memory(size)).get(), 7, size);
    const Memory<std::byte> taken(take_memory(size));
    EXPECT_GE(pages_there(taken.get(), taken.get() + size), size / 4096 - 1) << size;
    const Memory<std::byte> grown(grow_memory(nullptr, 0, size));
    std::memset(grown.get(), 7, size);
  }
}
#endif

#endif

TEST(Memory, FailsOnceHoweverManyThreadsAskForIt) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> failures = 0;
    const FailingMemory memory(5);
    const auto take_some = [&] {
      for (int i = 0; i < 50; ++i) failures += takes_some() ? 0 : 1;
    };
    std::thread other(take_some);
    take_some();
    other.join();
    EXPECT_EQ(failures, 1);
  }
}

#if !defined(CELLSWEEP_SANITIZED_TESTS)
TEST(Memory, MoreThanThereIsThrows) {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  for (const std::size_t size : {kMost, kMost - 64, kMost / 2}) {
    EXPECT_THROW(take_memory(size), std::bad_alloc);
    Memory<std::byte> memory(take_memory(10));
    EXPECT_THROW(grow_memory(memory.get(), 10, size), std::bad_alloc);
  }
}
#endif

TEST(AllocatorOfContainers, GetsItsMemoryHere) {
  Vector<int> numbers(1000, 4);
  EXPECT_THAT(numbers, testing::Each(4));
  EXPECT_TRUE(fails_at(1, [&] { numbers.resize(100'000); }));
  EXPECT_EQ(numbers.size(), 1000U);
  EXPECT_FALSE(fails_at(2, [&] { numbers.resize(100'000); }));
}

struct alignas(kMemoryAlignment) Line {
  char bytes[kMemoryAlignment];
};

TEST(AllocatorOfContainers, AlignsMemoryAsTheElementsAskFor) {
  for (std::size_t count = 1; count < 100; ++count) {
    EXPECT_EQ(address(Vector<Line>(count).data()) % kMemoryAlignment, 0U);
    EXPECT_EQ(address(Vector<double>(count).data()) % alignof(double), 0U);
  }
}

TEST(AllocatorOfContainers, RefusesANumberOfElementsWhoseBytesCannotBeCounted) {
  Allocator<double> allocator;
  EXPECT_THROW(allocator.allocate(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
}

}  // namespace
}  // namespace cellsweep
