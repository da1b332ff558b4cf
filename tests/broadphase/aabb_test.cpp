/// @file
/// The box itself: closed, and the same six numbers in Eigen's type.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cellsweep/aabb.h"
#include "cellsweep/world/eigen.h"
#include "contract/box_kinds.h"

namespace cellsweep {
namespace {

constexpr Aabb kUnit{{0, 0, 0}, {1, 1, 1}};

bool overlap_both_ways(const Aabb& a, const Aabb& b) {
  EXPECT_EQ(overlap(a, b), overlap(b, a));
  return overlap(a, b);
}

TEST(Aabb, ApartOnOneAxisIsApart) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Aabb above = kUnit;
    above.min[axis] = std::nextafter(1.0F, 2.0F);
    above.max[axis] = 2;
    EXPECT_FALSE(overlap_both_ways(kUnit, above)) << "axis " << axis;
    above.min[axis] = 1;
    EXPECT_TRUE(overlap_both_ways(kUnit, above)) << "axis " << axis;
    above.min[axis] = 0.5F;
    EXPECT_TRUE(overlap_both_ways(kUnit, above)) << "axis " << axis;
  }
}

TEST(Aabb, TouchingAtAFaceAnEdgeOrACornerIsOverlapping) {
  EXPECT_TRUE(overlap_both_ways(kUnit, {{1, 0, 0}, {2, 1, 1}}));
  EXPECT_TRUE(overlap_both_ways(kUnit, {{1, 1, 0}, {2, 2, 1}}));
  EXPECT_TRUE(overlap_both_ways(kUnit, {{1, 1, 1}, {2, 2, 2}}));
}

TEST(Aabb, ABoxInsideAnotherOverlapsIt) {
  EXPECT_TRUE(overlap_both_ways(kUnit, {{0.25F, 0.25F, 0.25F}, {0.5F, 0.5F, 0.5F}}));
  EXPECT_TRUE(overlap_both_ways(kUnit, {{-9, -9, -9}, {9, 9, 9}}));
}

TEST(Aabb, ACrossWithoutACornerInsideOverlaps) {
  EXPECT_TRUE(overlap_both_ways({{-5, 0, 0}, {5, 1, 1}}, {{0, -5, -5}, {1, 5, 5}}));
}

TEST(Aabb, APointOverlapsItselfAndTheBoxThatItLiesOn) {
  constexpr Aabb corner{{1, 1, 1}, {1, 1, 1}};
  EXPECT_TRUE(overlap_both_ways(corner, corner));
  EXPECT_TRUE(overlap_both_ways(corner, kUnit));
}

TEST(Aabb, ABoxWithANanOverlapsNothing) {
  Aabb broken = kUnit;
  broken.max[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(overlap_both_ways(kUnit, broken));
}

TEST(AabbInEigen, HasTheSameNumbersInTheSamePlaces) {
  const Eigen::AlignedBox3f box = to_eigen({{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(box.min(), Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(box.max(), Eigen::Vector3f(4, 5, 6));
}

TEST(AabbInEigen, ComesBackAsItWent) {
  contract::Random random(1);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const Aabb& box : contract::make_boxes(kind, random, 50)) EXPECT_EQ(from_eigen(to_eigen(box)), box);
  }
  EXPECT_EQ(from_eigen(Eigen::AlignedBox3f(Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(4, 5, 6))),
            (Aabb{{1, 2, 3}, {4, 5, 6}}));
}

TEST(AabbInEigen, OverlapIsEigensIntersection) {
  contract::Random random(2);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    const std::vector<Aabb> boxes = contract::make_boxes(kind, random, 40);
    for (const Aabb& a : boxes) {
      for (const Aabb& b : boxes) ASSERT_EQ(overlap(a, b), to_eigen(a).intersects(to_eigen(b))) << kind;
    }
  }
}

TEST(AabbInEigen, AnEmptyBoxConvertsToOneThatIsTheWrongWayRound) {
  const Aabb box = from_eigen(Eigen::AlignedBox3f());
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_GT(box.min[axis], box.max[axis]);
}

}  // namespace
}  // namespace cellsweep
