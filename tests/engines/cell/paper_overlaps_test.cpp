/// @file
/// Steps C11 and C12 of cell-paper: the keys of the pairs of changed IDs.
#include <gmock/gmock.h>

#include <random>

#include "engines/cell/spu/paper/overlap_all.h"
#include "engines/cell/spu/paper/overlap_walk.h"

namespace cellsweep::cell::paper {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

struct Keys {
  void add(std::uint32_t key) { list.push_back(key); }
  std::vector<std::uint32_t> list;
};

using Intervals = std::vector<std::pair<float, float>>;

/// ID words of the bodies 1, 2, 3 … in sorted order.
std::vector<std::uint32_t> sorted_ids(const Intervals& bodies, bool literal = false) {
  std::vector<std::pair<float, std::uint32_t>> ends;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    ends.emplace_back(bodies[i].first, i + 1);
    ends.emplace_back(bodies[i].second, (i + 1) | kMaximumFlag);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> ids;
  for (const auto& [value, id] : ends) ids.push_back(literal ? id & ~kMaximumFlag : id);
  ids.resize(round_up(static_cast<std::uint32_t>(ids.size()), kLanes), kUnchanged);
  return ids;
}

std::vector<std::uint32_t> walk(const Intervals& bodies, const std::vector<std::int32_t>& changed) {
  const auto ids = sorted_ids(bodies);
  std::vector<Place> places(bodies.size() + 1);
  build_place_table(ids.data(), static_cast<std::uint32_t>(ids.size()), places.data());
  Keys keys;
  walk_overlaps(ids.data(), places.data(), changed.data(), static_cast<std::uint32_t>(changed.size()), keys);
  return keys.list;
}

std::vector<std::uint32_t> walk_literally(const Intervals& bodies, const std::vector<std::int32_t>& changed) {
  const auto ids = sorted_ids(bodies, true);
  Keys keys;
  walk_overlaps_literal(ids.data(), static_cast<std::uint32_t>(ids.size()), changed.data(),
                        static_cast<std::uint32_t>(changed.size()), keys);
  return keys.list;
}

std::vector<float> by_body(const Intervals& bodies) {
  std::vector<float> values;
  for (const auto& [low, high] : bodies) {
    values.push_back(low);
    values.push_back(high);
  }
  return values;
}

TEST(PairKey, HoldsTheSmallerIdBelowTheLargerOneAsListing4_1Does) {
  EXPECT_EQ(pair_key_of_ids(2, 3), 0x00030002U);
  EXPECT_EQ(pair_key_of_ids(3, 2), 0x00030002U);
  EXPECT_EQ(pair_key_of_ids(65535, 1), 0xffff0001U);
}

TEST(OverlapWalk, FindsIdsThatBeginOnTheWay) {
  EXPECT_THAT(walk({{0, 10}, {1, 2}, {5, 20}, {11, 12}}, {1}),
              UnorderedElementsAre(pair_key_of_ids(1, 2), pair_key_of_ids(1, 3)));
}

TEST(OverlapWalk, FindsTheIntervalThatContainsTheChangedOne) {
  EXPECT_THAT(walk({{4, 5}, {0, 10}}, {1}), ElementsAre(pair_key_of_ids(1, 2)));
  EXPECT_THAT(walk_literally({{4, 5}, {0, 10}}, {1}), IsEmpty()) << "Listing 4.12 cannot see it";
}

TEST(OverlapWalk, FindsATouchFromEitherSide) {
  EXPECT_THAT(walk({{0, 1}, {1, 2}}, {1}), ElementsAre(pair_key_of_ids(1, 2)));
  EXPECT_THAT(walk({{0, 1}, {1, 2}}, {2}), ElementsAre(pair_key_of_ids(1, 2)));
}

TEST(OverlapWalk, SendsAPairOfTwoChangedIdsOnce) {
  EXPECT_THAT(walk({{0, 2}, {1, 3}, {2, 9}}, {3, 2, 1}),
              UnorderedElementsAre(pair_key_of_ids(1, 2), pair_key_of_ids(1, 3), pair_key_of_ids(2, 3)));
}

TEST(OverlapWalk, FindsNothingForAnIntervalAlone) {
  EXPECT_THAT(walk({{0, 1}, {5, 6}, {8, 9}}, {2}), IsEmpty());
}

TEST(OverlapWalkLiteral, SendsAnIdAsOftenAsItIsMet) {
  const std::uint32_t key = pair_key_of_ids(1, 2);
  EXPECT_THAT(walk_literally({{0, 10}, {1, 2}}, {1}), ElementsAre(key, key));
}

TEST(OverlapWalkLiteral, EndsWithTheArrayWhenTheIdIsNotThere) {
  EXPECT_THAT(walk_literally({{0, 1}, {2, 3}}, {7}), IsEmpty());
}

TEST(OverlapAll, LooksValuesUpAsFigure4_8Does) {
  // The figure's ID 2 is upside down (22, 20); here it is 20, 22.
  const std::vector<float> values = {-1, 1, 20, 22, 14, 16, -15, -13, 6, 8, 31, 33, 10, 12, 40, 42};
  EXPECT_EQ(minimum_of(values.data(), 6), 31);
  EXPECT_EQ(maximum_of(values.data(), 6), 33);
  EXPECT_EQ(minimum_of(values.data(), 1), -1);
  EXPECT_EQ(maximum_of(values.data(), 8), 42);
  const std::int32_t changed[] = {6};
  Keys keys;
  Keys apart;
  test_all(values.data(), 8, changed, 1, keys, apart);
  EXPECT_THAT(keys.list, IsEmpty());
  EXPECT_EQ(apart.list.size(), 7U);
}

TEST(OverlapAll, PassesOverIdsThatNoBodyHas) {
  std::vector<float> values = by_body({{0, 1}, {0, 1}, {5, 6}});
  __builtin_memcpy(&values[2], &kPaddingValueBits, sizeof(float));
  const std::int32_t changed[] = {3};
  Keys keys;
  Keys apart;
  test_all(values.data(), 3, changed, 1, keys, apart);
  EXPECT_THAT(keys.list, IsEmpty());
  EXPECT_THAT(apart.list, ElementsAre(pair_key_of_ids(1, 3)));
}

// Both methods against all-against-all, on every kind of small interval.
TEST(OverlapMethods, SendEveryPairOfAChangedIdOnce) {
  std::mt19937 random(9);
  for (int round = 0; round < 2000; ++round) {
    Intervals bodies(random() % 9 + 1);
    std::vector<std::int32_t> changed;
    for (auto& [low, high] : bodies) {
      low = static_cast<float>(random() % 8);
      high = low + static_cast<float>(random() % 4);
    }
    for (auto id = static_cast<std::int32_t>(bodies.size()); id > 0; --id) {
      if (random() % 2 == 0) changed.push_back(id);
    }
    std::vector<std::uint32_t> expected;
    std::vector<std::uint32_t> expected_apart;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const auto is_changed = [&](std::uint32_t id) {
          return std::ranges::count(changed, static_cast<std::int32_t>(id)) == 1;
        };
        if (!is_changed(i + 1) && !is_changed(j + 1)) continue;
        const bool overlapping = bodies[i].first <= bodies[j].second && bodies[j].first <= bodies[i].second;
        (overlapping ? expected : expected_apart).push_back(pair_key_of_ids(i + 1, j + 1));
      }
    }
    ASSERT_THAT(walk(bodies, changed), testing::UnorderedElementsAreArray(expected));
    Keys keys;
    Keys apart;
    const auto values = by_body(bodies);
    test_all(values.data(), static_cast<std::uint32_t>(bodies.size()), changed.data(),
             static_cast<std::uint32_t>(changed.size()), keys, apart);
    ASSERT_THAT(keys.list, testing::UnorderedElementsAreArray(expected));
    ASSERT_THAT(apart.list, testing::UnorderedElementsAreArray(expected_apart));
  }
}

}  // namespace
}  // namespace cellsweep::cell::paper
