/// @file
/// What is made canonical, and what is a valid box.
#include "geometry/canonical.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "contract/box_kinds.h"
#include "geometry/numbers.h"

namespace cellsweep {
namespace {

/// Bits, so that −0 and 0 are told apart.
std::uint32_t bits(float value) {
  std::uint32_t result = 0;
  std::memcpy(&result, &value, sizeof value);
  return result;
}

TEST(CanonicalValue, OfMinusZeroAndEveryDenormalIsPlusZero) {
  for (const float value : {0.0F, -0.0F, kDenormal, -kDenormal, FLT_MIN - kDenormal, kDenormal - FLT_MIN}) {
    EXPECT_EQ(bits(canonical(value)), 0U) << value;
  }
}

TEST(CanonicalValue, OfEveryOtherNumberIsTheNumber) {
  for (const float value : {FLT_MIN, -FLT_MIN, 1.0F, -1.0F, FLT_MAX, -FLT_MAX, kInfinity, -kInfinity}) {
    EXPECT_EQ(bits(canonical(value)), bits(value)) << value;
  }
  EXPECT_TRUE(std::isnan(canonical(kNan)));
}

TEST(CanonicalBox, HasItsOwnValuesInEveryPlace) {
  const Aabb box{{-kDenormal, 2, -0.0F}, {4, kDenormal, 6}};
  EXPECT_EQ(canonical(box), (Aabb{{0, 2, 0}, {4, 0, 6}}));
  EXPECT_EQ(bits(canonical(box).min[0]), 0U);
  EXPECT_EQ(bits(canonical(box).min[2]), 0U);
}

TEST(CanonicalBox, IsTheOneThatTheTestsMakeThemselves) {
  contract::Random random(6);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const Aabb& box : make_boxes(kind, random, 50))
      EXPECT_EQ(canonical(box), contract::canonical_box(box));
  }
}

TEST(ValidBox, MayBeAPointOrASheetOrAsLargeAsFloatsGo) {
  EXPECT_TRUE(is_valid({{0, 0, 0}, {1, 2, 3}}));
  EXPECT_TRUE(is_valid({{1, 1, 1}, {1, 1, 1}}));
  EXPECT_TRUE(is_valid({{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}}));
}

TEST(ValidBox, HasNoNanNoInfinityAndNoAxisTheWrongWayRound) {
  const float bad_ends[][2] = {{kNan, 1},       {0, kNan},  {kNan, kNan},           {0, kInfinity},
                               {-kInfinity, 0}, {1, 0},     {kInfinity, kInfinity}, {-kInfinity, -kInfinity},
                               {FLT_MAX, 0},    {0, -1e-3F}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const auto& [low, high] : bad_ends) {
      Aabb box{{0, 0, 0}, {1, 1, 1}};
      box.min[axis] = low;
      box.max[axis] = high;
      EXPECT_FALSE(is_valid(box)) << "axis " << axis << ": " << low << " to " << high;
    }
  }
}

}  // namespace
}  // namespace cellsweep
