/// @file
/// An id that is listed twice is found wherever the two stand and whatever the others are.
#include "broadphase/bodies/distinct_ids.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/thread_pool.h"
#include "base/tuning.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using Ids = std::vector<BodyId>;

/// Different ones: multiples of an odd number.
Ids multiples(std::size_t count, BodyId factor) {
  Ids ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<BodyId>(i) * factor;
  return ids;
}

/// Different ones whose hashes have the upper bits in common, so that they crowd into a few words.
Ids crowded(std::size_t count) {
  Ids ids;
  for (std::uint64_t id = 0; ids.size() < count; ++id) {
    if (id * 0x9e3779b97f4a7c15U >> 54 == 0) ids.push_back(static_cast<BodyId>(id));
  }
  return ids;
}

/// By so many workers.
class DistinctIds : public testing::TestWithParam<unsigned> {
 protected:
  void expect_distinct_but_for_a_repeated_one(Ids ids, Random& random) {
    ASSERT_TRUE(are_distinct(crew_, ids)) << ids.size() << " ids";
    for (int i = 0; i < 20 && ids.size() > 1; ++i) {
      const std::size_t place = random.below(ids.size());
      const std::size_t other = (place + 1 + random.below(ids.size() - 1)) % ids.size();
      const BodyId before = std::exchange(ids[place], ids[other]);
      ASSERT_FALSE(are_distinct(crew_, ids)) << ids.size() << " ids, " << place << " and " << other;
      ids[place] = before;
    }
  }

  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
};

TEST_P(DistinctIds, AreThoseOfWhichNoTwoAreAlike) {
  Random random(1);
  for (const std::size_t count : {0, 1, 2, 63, 64, 65, 1000, 30'000}) {
    for (const BodyId factor : {1U, 3U, 2'654'435'761U, 0xffffffffU, 65'537U})
      expect_distinct_but_for_a_repeated_one(multiples(count, factor), random);
  }
}

TEST_P(DistinctIds, MayBeSoManyThatTheyAreCutIntoBuckets) {
  Random random(3);
  for (const BodyId factor : {2'654'435'761U, 8192U})
    expect_distinct_but_for_a_repeated_one(multiples(3 * tuning::kIdsOfBucket, factor), random);
}

TEST_P(DistinctIds, MayHaveHashesThatCrowdTogether) {
  Random random(2);
  expect_distinct_but_for_a_repeated_one(crowded(5000), random);
}

TEST_P(DistinctIds, AreNotOneAndTheSameManyTimes) {
  EXPECT_FALSE(are_distinct(crew_, Ids(10'000, 7)));
  EXPECT_FALSE(are_distinct(crew_, Ids{0xffffffff, 0, 0xffffffff}));
}

TEST_P(DistinctIds, AreNotToldWithoutMemory) {
  for (const Ids& ids : {multiples(3000, 3), crowded(3000)}) {
    bool distinct = false;
    std::uint64_t place = 1;
    while (fails_at(place, [&] { distinct = are_distinct(crew_, ids); })) ++place;
    EXPECT_TRUE(distinct);
    EXPECT_GE(place, 3U);
  }
}

INSTANTIATE_TEST_SUITE_P(Workers, DistinctIds, testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace cellsweep
