/// @file
/// Boxes as vectors: what is asked of three axes at a time is what a loop over them says.
#include "geometry/box_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <vector>

#include "cellsweep/engine/slots.h"
#include "contract/box_kinds.h"
#include "geometry/canonical.h"
#include "geometry/numbers.h"

namespace cellsweep {
namespace {

using contract::box_text;

constexpr Aabb kBox = {{1, 2, 3}, {4, 5, 6}};

std::array<std::uint32_t, 6> bits(const Aabb& box) {
  std::array<std::uint32_t, 6> result{};
  std::memcpy(result.data(), &box, sizeof box);
  return result;
}

/// Boxes of every kind, boxes with values that are no numbers, and nobody's.
std::vector<Aabb> many_boxes() {
  contract::Random random(1);
  std::vector<Aabb> boxes = {kNobody, kBox};
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    const std::vector<Aabb> more = make_boxes(kind, random, 12);
    boxes.insert(boxes.end(), more.begin(), more.end());
  }
  for (std::size_t face = 0; face < 6; ++face) {
    for (const float value : {0.0F, -0.0F, kDenormal, -kDenormal, FLT_MIN, -FLT_MIN, FLT_MIN - kDenormal,
                              FLT_MAX, -FLT_MAX, kInfinity, -kInfinity, kNan, 3.5F}) {
      Aabb box = kBox;
      (face < 3 ? box.min : box.max)[face % 3] = value;
      boxes.push_back(box);
    }
  }
#ifdef __powerpc__
  // A Cell's vectors take denormals for 0, which every box has in their place once it is admitted.
  for (Aabb& box : boxes) box = contract::canonical_box(box);
#endif
  return boxes;
}

bool encloses_by_axis(const Aabb& fat, const Aabb& box) {
  bool enclosed = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    enclosed = enclosed && fat.min[axis] <= box.min[axis] && box.max[axis] <= fat.max[axis];
  return enclosed;
}

TEST(BoxLanes, HoldTheAxesInTheirFirstThree) {
  const BoxLanes lanes(kBox);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(lanes.min[axis], kBox.min[axis]);
    EXPECT_EQ(lanes.max[axis], kBox.max[axis]);
  }
}

TEST(BoxNumbers, AreTheFirstAndTheLastFourHoweverTheyAreRead) {
  for (const BoxNumbers& numbers : {BoxNumbers(kBox), BoxNumbers::just_written(kBox)}) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(numbers.first_four[i], i < 3 ? kBox.min[i] : kBox.max[0]) << i;
      EXPECT_EQ(numbers.last_four[i], i < 1 ? kBox.min[2] : kBox.max[i - 1]) << i;
    }
  }
}

TEST(BoxLanes, SayOfEveryTwoBoxesWhatALoopOverTheAxesSays) {
  const std::vector<Aabb> boxes = many_boxes();
  for (const Aabb& one : boxes) {
    for (const Aabb& other : boxes) {
      const BoxLanes a(one);
      const BoxLanes b(other);
      ASSERT_EQ(overlap(a, b), overlap(one, other)) << box_text(one) << " and " << box_text(other);
      ASSERT_EQ(encloses(a, b), encloses_by_axis(one, other)) << box_text(one) << " and " << box_text(other);
      ASSERT_EQ(same_bits(a, b), bits(one) == bits(other)) << box_text(one) << " and " << box_text(other);
    }
  }
}

TEST(BoxLanes, AnAxisThatDiffersIsSeenOnEachOfThem) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Aabb aside = kBox;
    aside.min[axis] = 10;
    aside.max[axis] = 11;
    EXPECT_FALSE(overlap(BoxLanes(kBox), BoxLanes(aside))) << axis;
    EXPECT_FALSE(overlap(BoxLanes(aside), BoxLanes(kBox))) << axis;
    Aabb smaller = kBox;
    smaller.min[axis] += 0.5F;
    EXPECT_TRUE(encloses(BoxLanes(kBox), BoxLanes(smaller))) << axis;
    EXPECT_FALSE(encloses(BoxLanes(smaller), BoxLanes(kBox))) << axis;
    EXPECT_FALSE(same_bits(BoxLanes(kBox), BoxLanes(smaller))) << axis;
  }
}

TEST(BoxLanes, MinusZeroIsZeroButOfOtherBits) {
  const Aabb zero{};
  const Aabb minus_zero{{-0.0F, -0.0F, -0.0F}, {-0.0F, -0.0F, -0.0F}};
  EXPECT_TRUE(overlap(BoxLanes(zero), BoxLanes(minus_zero)));
  EXPECT_FALSE(same_bits(BoxLanes(zero), BoxLanes(minus_zero)));
}

TEST(BoxLanes, AreCleanWhereABoxIsValidAndCanonicalAsItIs) {
  for (const Aabb& box : many_boxes()) {
    const bool clean = is_valid(box) && bits(canonical(box)) == bits(box);
    ASSERT_EQ(on_all_axes(clean_lanes(BoxLanes(box))), clean) << box_text(box);
  }
}

}  // namespace
}  // namespace cellsweep
