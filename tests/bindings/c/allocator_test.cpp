/// @file
/// Memory of a C program's own: all that grows comes from there and goes back, and where it has none the call
/// changes nothing. One program, because the allocator is the process's.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <vector>

#include "bindings/c/c_world.h"

namespace cellsweep::c {
namespace {

struct Memory {
  std::atomic<long> blocks = 0;
  std::atomic<long> taken = 0;
  std::atomic<long> fails_at = -1;
};

void* take(void* context, std::size_t bytes, std::size_t alignment) {
  auto& memory = *static_cast<Memory*>(context);
  EXPECT_GT(bytes, 0U);
  EXPECT_EQ(alignment & (alignment - 1), 0U);
  if (++memory.taken == memory.fails_at) return nullptr;
  ++memory.blocks;
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void give(void* context, void* memory) {
  EXPECT_NE(memory, nullptr);
  --static_cast<Memory*>(context)->blocks;
  std::free(memory);
}

Memory& memory() {
  static Memory the_one;
  return the_one;
}

void set_allocator() {
  static const cellsweep_status status = [] {
    const cellsweep_allocator allocator = {take, give, &memory()};
    return cellsweep_set_allocator(&allocator, nullptr);
  }();
  ASSERT_EQ(status, CELLSWEEP_OK);
}

std::vector<cellsweep_aabb> many_cubes() {
  std::vector<cellsweep_aabb> cubes(1000, kCube);
  for (std::size_t i = 0; i < cubes.size(); ++i) cubes[i].max[0] += static_cast<float>(i % 10);
  for (std::size_t i = 0; i < cubes.size(); ++i) cubes[i].min[1] -= static_cast<float>(i / 10) / 700;
  return cubes;
}

/// A life in which each call is made until it succeeds, at most once more; false when one failed.
bool live(const std::vector<cellsweep_aabb>& cubes) {
  bool all_succeeded = true;
  const auto try_twice = [&](const auto& call) {
    cellsweep_status status = call();
    if (status == CELLSWEEP_NO_MEMORY) {
      all_succeeded = false;
      status = call();
    }
    ASSERT_EQ(status, CELLSWEEP_OK);
  };
  const World world = make_world();
  const cellsweep_boxes boxes = cellsweep_boxes_of(cubes.data(), cubes.size());
  std::vector<uint32_t> ids(cubes.size());
  try_twice([&] { return cellsweep_add(world.get(), boxes, ids.data(), nullptr); });
  for (int round = 0; round < 2; ++round) {
    try_twice([&] { return cellsweep_move(world.get(), ids_in(ids), boxes, nullptr); });
    try_twice([&] { return cellsweep_update(world.get(), nullptr, nullptr); });
  }
  const cellsweep_pair* pairs = nullptr;
  std::size_t count = 0;
  try_twice([&] { return cellsweep_pairs(world.get(), &pairs, &count, nullptr); });
  uint64_t expected = 0;
  try_twice([&] { return cellsweep_count_pairs(boxes, nullptr, &expected, nullptr); });
  EXPECT_EQ(count, expected);
  return all_succeeded;
}

TEST(CAllocator, HasAllThatGrowsAndGetsItBack) {
  set_allocator();
  ASSERT_TRUE(live(many_cubes()));
  EXPECT_GT(memory().taken, 10);
  EXPECT_EQ(memory().blocks, 0);
}

TEST(CAllocator, WithoutMemoryFailsTheCallThatCanBeMadeAgain) {
  set_allocator();
  const auto cubes = many_cubes();
  bool has_failed = true;
  for (long n = 1; has_failed; n += 1 + n / 8) {
    memory().fails_at = memory().taken + n;
    has_failed = !live(cubes);
    ASSERT_EQ(memory().blocks, 0) << "failing at " << n;
    ASSERT_LT(n, 10000);
    if (HasFailure()) return;
  }
  memory().fails_at = -1;
}

TEST(CAllocator, ComesBeforeEverythingElse) {
  set_allocator();
  make_cubes(3);
  const cellsweep_allocator late = {take, give, &memory()};
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_set_allocator(&late, &why), CELLSWEEP_BAD_INPUT);
  EXPECT_STREQ(why.message,
               "The library holds memory from elsewhere: set the allocator before all other calls.");
}

TEST(CAllocator, NeedsBothFunctions) {
  const cellsweep_allocator none = {nullptr, give, nullptr};
  EXPECT_EQ(cellsweep_set_allocator(&none, nullptr), CELLSWEEP_BAD_INPUT);
}

}  // namespace
}  // namespace cellsweep::c
