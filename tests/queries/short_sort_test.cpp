/// @file
/// Few answers are sorted as std::sort sorts them, however many are alike.
#include "queries/short_sort.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "contract/random.h"
#include "queries/nearest_list.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

TEST(ShortSort, SortsIdsOfAnyNumber) {
  for (std::size_t count = 0; count <= kMostCounted<BodyId> + 2; ++count) {
    Random random(count);
    std::vector<BodyId> ids(count);
    for (BodyId& id : ids) id = static_cast<BodyId>(random.bits());
    if (count > 1) ids[count / 2] = std::numeric_limits<BodyId>::max();
    std::vector<BodyId> expected = ids;
    std::ranges::sort(expected);
    sort_answers(std::span(ids), std::identity(), std::less());
    EXPECT_EQ(ids, expected) << count;
  }
}

TEST(ShortSort, SortsNeighborsOfWhichManyAreAsFar) {
  for (std::size_t count = 0; count <= kMostCounted<double> + 2; ++count) {
    for (const std::uint64_t distances : {1, 2, 7, 1'000'000}) {
      Random random(count * distances);
      std::vector<Neighbor> neighbors(count);
      for (Neighbor& neighbor : neighbors) {
        neighbor = {static_cast<BodyId>(random.bits()), static_cast<double>(random.bits() % distances)};
        if (random.bits() % 9 == 0) neighbor.distance = std::numeric_limits<double>::infinity();
      }
      std::vector<Neighbor> expected = neighbors;
      std::ranges::sort(expected, NearestList::Before());
      sort_answers(
          std::span(neighbors), [](const Neighbor& neighbor) { return neighbor.distance; },
          NearestList::Before());
      EXPECT_EQ(neighbors, expected) << count << " of " << distances;
    }
  }
}

}  // namespace
}  // namespace cellsweep::queries
