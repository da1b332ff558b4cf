/// @file
/// Few answers are sorted as std::sort sorts them, however many are alike, by the kernels of each instruction
/// set.
#include "queries/short_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "contract/random.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

/// Any numbers, each once, in no order.
std::vector<BodyId> some_ids(std::size_t count, Random& random) {
  std::set<BodyId> ids;
  if (count > 0) ids.insert(std::numeric_limits<BodyId>::max());
  if (count > 1) ids.insert(0);
  if (count > 3) ids.insert({0x7fff'ffff, 0x8000'0000});
  while (ids.size() < count) ids.insert(static_cast<BodyId>(random.bits()));
  std::vector<BodyId> list(ids.begin(), ids.end());
  for (std::size_t i = 1; i < list.size(); ++i) std::swap(list[i], list[random.bits() % (i + 1)]);
  return list;
}

class ShortSort : public testing::TestWithParam<VectorIsa> {};

TEST_P(ShortSort, SortsIdsOfAnyNumber) {
  for (std::size_t count = 0; count <= kMostRanked + 2; ++count) {
    Random random(count);
    std::vector<BodyId> ids = some_ids(count, random);
    std::vector<BodyId> expected = ids;
    std::ranges::sort(expected);
    sort_ids(query_kernels(GetParam()), ids);
    ASSERT_EQ(ids, expected) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, ShortSort,
                         testing::Values(VectorIsa::portable, VectorIsa::avx2, VectorIsa::avx512));

TEST(ShortSortOfNeighbors, SortsThemWhenManyAreAsFar) {
  for (std::size_t count = 0; count <= 70; ++count) {
    for (const std::uint64_t distances : {1, 2, 7, 1'000'000}) {
      Random random(count * distances);
      std::vector<Neighbor> neighbors(count);
      for (Neighbor& neighbor : neighbors) {
        neighbor = {static_cast<BodyId>(random.bits()), static_cast<double>(random.bits() % distances)};
        if (random.bits() % 9 == 0) neighbor.distance = std::numeric_limits<double>::infinity();
      }
      std::vector<Neighbor> expected = neighbors;
      std::ranges::sort(expected, Nearer());
      sort_neighbors(neighbors);
      EXPECT_EQ(neighbors, expected) << count << " of " << distances;
    }
  }
}

// Where there is no tree a path finds a body in each of its cells.
TEST(ShortSortOfTouches, SortsThemWhenManyAreTheSame) {
  for (std::size_t count = 0; count <= 70; ++count) {
    for (const std::uint64_t kinds : {1, 2, 7, 1'000'000}) {
      Random random(count * kinds);
      std::vector<Touch> touches(count);
      for (Touch& touch : touches)
        touch = {static_cast<BodyId>(random.bits() % kinds), static_cast<double>(random.bits() % kinds)};
      std::vector<Touch> expected = touches;
      std::ranges::sort(expected, Sooner());
      sort_touches(touches);
      EXPECT_EQ(touches, expected) << count << " of " << kinds;
    }
  }
}

}  // namespace
}  // namespace cellsweep::queries
