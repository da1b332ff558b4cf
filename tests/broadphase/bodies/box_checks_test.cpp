/// @file
/// Lists of boxes that are clean or valid, and the one that is not, wherever it stands.
#include "broadphase/bodies/box_checks.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <limits>
#include <vector>

#include "cellsweep/engine/slots.h"

namespace cellsweep {
namespace {

constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr Aabb kBox = {{-1, 0, 3}, {4, 5, FLT_MAX}};

TEST(BoxChecks, NoBoxesAreFine) {
  EXPECT_TRUE(are_clean({}));
  EXPECT_TRUE(are_valid({}));
}

/// Expects that lists with this box at any place are clean or valid as it is.
void expect_of_lists(const Aabb& box, bool clean, bool valid) {
  for (const std::size_t count : {1, 2, 3, 4, 5, 33}) {
    for (std::size_t place = 0; place < count; ++place) {
      std::vector<Aabb> boxes(count, kBox);
      boxes[place] = box;
      EXPECT_EQ(are_clean(boxes), clean) << place << " of " << count;
      EXPECT_EQ(are_valid(boxes), valid) << place << " of " << count;
    }
  }
}

TEST(BoxChecks, BoxesThatNeedNoChangeAreClean) {
  expect_of_lists(kBox, true, true);
  expect_of_lists(Aabb{}, true, true);
  expect_of_lists({{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {-FLT_MAX, FLT_MIN, -FLT_MIN}}, true, true);
}

TEST(BoxChecks, MinusZeroAndDenormalsAreValidButNotClean) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float value : {-0.0F, kDenormal, -kDenormal}) {
      Aabb low = {{-1, -1, -1}, {1, 1, 1}};
      Aabb high = low;
      low.min[axis] = value;
      high.max[axis] = value;
      expect_of_lists(low, false, true);
      expect_of_lists(high, false, true);
    }
  }
  // The wrong way round until both are zero.
  expect_of_lists({{kDenormal, 0, 0}, {-kDenormal, 0, 0}}, false, true);
}

TEST(BoxChecks, BoxesThatAreNoneAreNeither) {
  expect_of_lists(kNobody, false, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Aabb reversed = kBox;
    reversed.min[axis] = FLT_MAX;
    reversed.max[axis] = 0;
    expect_of_lists(reversed, false, false);
    for (const float value : {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
      Aabb low = kBox;
      Aabb high = kBox;
      low.min[axis] = value;
      high.max[axis] = value;
      expect_of_lists(low, false, false);
      expect_of_lists(high, false, false);
    }
  }
}

}  // namespace
}  // namespace cellsweep
