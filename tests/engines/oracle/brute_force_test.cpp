/// @file
/// The oracle judged by a second one that is written another way, and by scenes that can be counted by hand.
#include "engines/oracle/brute_force.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cfloat>
#include <limits>

#include "contract/box_kinds.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

/// Two closed intervals have a point in common when the larger lower end lies in both.
bool share_a_point(float low_a, float high_a, float low_b, float high_b) {
  const float candidate = std::max(low_a, low_b);
  return !(candidate > high_a) && !(candidate > high_b);
}

/// Boxes one by one, axes one by one, each pair looked at from the body of the smaller id.
std::vector<Pair> second_oracle(const std::vector<BodyId>& ids, const std::vector<Aabb>& given) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t j = 0; j < ids.size(); ++j) {
      if (ids[i] >= ids[j]) continue;
      const Aabb a = contract::canonical_box(given[i]);
      const Aabb b = contract::canonical_box(given[j]);
      int axes = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        axes += share_a_point(a.min[k], a.max[k], b.min[k], b.max[k]) ? 1 : 0;
      }
      if (axes == 3) pairs.push_back({ids[i], ids[j]});
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](Pair one, Pair other) { return one.a != other.a ? one.a < other.a : one.b < other.b; });
  return pairs;
}

std::vector<BodyId> counted_ids(std::size_t count) {
  std::vector<BodyId> ids;
  for (std::size_t i = 0; i < count; ++i) ids.push_back(static_cast<BodyId>(i));
  return ids;
}

/// Different ids from the whole range, in no order: an odd factor permutes the 32-bit numbers.
std::vector<BodyId> scattered_ids(std::size_t count) {
  std::vector<BodyId> ids = {0xffffffff, 0};
  for (std::size_t i = 2; i < count; ++i) ids.push_back(static_cast<BodyId>(i) * 0x9e3779b1U);
  ids.resize(count);
  return ids;
}

TEST(BruteForce, EqualsASecondOracleOnEveryKindOfBoxesAtEverySizeUpToThreeBlocks) {
  contract::Random random(1);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (std::size_t count = 0; count <= 50; ++count) {
      const std::vector<Aabb> boxes = make_boxes(kind, random, count);
      ASSERT_EQ(brute_force_pairs(boxes), second_oracle(counted_ids(count), boxes)) << kind << ", " << count;
      const std::vector<BodyId> ids = scattered_ids(count);
      ASSERT_EQ(brute_force_pairs(ids, boxes), second_oracle(ids, boxes)) << kind << ", " << count;
    }
  }
}

TEST(BruteForce, EqualsASecondOracleOnManyBodies) {
  contract::Random random(2);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    const std::vector<Aabb> boxes = make_boxes(kind, random, 300);
    const std::vector<BodyId> ids = scattered_ids(300);
    ASSERT_EQ(brute_force_pairs(ids, boxes), second_oracle(ids, boxes)) << kind;
  }
}

TEST(BruteForce, NoBodiesAndOneBodyHaveNoPairs) {
  EXPECT_THAT(brute_force_pairs(std::vector<Aabb>{}), IsEmpty());
  EXPECT_THAT(brute_force_pairs(std::vector<Aabb>{{{0, 0, 0}, {1, 1, 1}}}), IsEmpty());
}

TEST(BruteForce, NamesThePairsByTheIdsThatItWasGiven) {
  const std::vector<BodyId> ids = {9, 4, 0xffffffff};
  const std::vector<Aabb> boxes = {{{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}, {3, 3, 3}}, {{2, 2, 2}, {4, 4, 4}}};
  EXPECT_THAT(brute_force_pairs(ids, boxes),
              ElementsAre(Pair{4, 9}, Pair{4, 0xffffffff}, Pair{9, 0xffffffff}));
}

TEST(BruteForce, ALatticeOfTouchingCubesHasItsTwentySixNeighbours) {
  std::vector<Aabb> lattice;
  for (int i = 0; i < 27; ++i) {
    const auto x = static_cast<float>(i % 3);
    const auto y = static_cast<float>(i / 3 % 3);
    const auto z = static_cast<float>(i / 9);
    lattice.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
  }
  // A row of 3 has 7 ordered neighbour relations (itself included), so 7³ in space, 27 of them with itself.
  EXPECT_EQ(brute_force_pairs(lattice).size(), (7U * 7U * 7U - 27U) / 2U);
}

TEST(BruteForce, IdenticalBoxesAllOverlap) {
  EXPECT_EQ(brute_force_pairs(std::vector<Aabb>(2000, Aabb{{1, 2, 3}, {4, 5, 6}})).size(),
            2000U * 1999U / 2U);
}

TEST(BruteForce, MinusZeroAndDenormalsAreZeroOnEveryAxis) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Aabb below{{-1, -1, -1}, {1, 1, 1}};
    Aabb above = below;
    below.max[axis] = -kDenormal;
    above.min[axis] = FLT_MIN - kDenormal;
    EXPECT_EQ(brute_force_pairs(std::vector<Aabb>{below, above}).size(), 1U) << "axis " << axis;
    above.min[axis] = FLT_MIN;
    EXPECT_THAT(brute_force_pairs(std::vector<Aabb>{below, above}), IsEmpty()) << "axis " << axis;
  }
}

TEST(BruteForce, TheLargestNumbersAreNumbersLikeOthers) {
  const Aabb everything{{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb far_corner{{FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb near_corner{{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
  EXPECT_THAT(brute_force_pairs(std::vector<Aabb>{everything, far_corner, near_corner}),
              ElementsAre(Pair{0, 1}, Pair{0, 2}));
}

TEST(BruteForce, TheHashOfALatticeCornerIsTheOneComputedElsewhere) {
  const std::vector<Aabb> three = {{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}, {{1, 0, 0}, {2, 1, 1}}};
  EXPECT_EQ(pair_set_hash(brute_force_pairs(three)), 0xb52222ea01c57a2dULL);
}

}  // namespace
}  // namespace cellsweep
