/// @file
/// What is made canonical, what is refused, and in which words.
#include "geometry/canonical.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "contract/box_kinds.h"

namespace cellsweep {
namespace {

using testing::HasSubstr;

constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

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

TEST(InvalidBoxStatus, NamesTheBodyTheAxisAndTheNumbers) {
  const Status reversed = invalid_box_status(4242, {{0, 7.5F, 0}, {1, 3.25F, 1}});
  EXPECT_EQ(reversed.code, StatusCode::invalid_box);
  EXPECT_EQ(reversed.body, 4242U);
  EXPECT_THAT(reversed.message,
              testing::AllOf(HasSubstr("4242"), HasSubstr(" y"), HasSubstr("7.5"), HasSubstr("3.25")));

  const Status infinite = invalid_box_status(0, {{0, 0, 0}, {1, 1, kInfinity}});
  EXPECT_EQ(infinite.body, 0U);
  EXPECT_THAT(infinite.message, testing::AllOf(HasSubstr("body 0"), HasSubstr(" z"), HasSubstr("inf"),
                                               HasSubstr("not finite")));

  const Status nan = invalid_box_status(0xffffffff, {{kNan, 0, 0}, {1, 1, 1}});
  EXPECT_THAT(nan.message, testing::AllOf(HasSubstr("4294967295"), HasSubstr(" x"), HasSubstr("nan")));
}

TEST(LengthStatus, NamesBothLengths) {
  const Status status = length_status(31, 47);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.body, std::nullopt);
  EXPECT_THAT(status.message, testing::AllOf(HasSubstr("31"), HasSubstr("47")));
}

TEST(BodyStatus, NamesTheBody) {
  const Status unknown = unknown_body_status(77);
  EXPECT_EQ(unknown.code, StatusCode::unknown_body);
  EXPECT_EQ(unknown.body, 77U);
  EXPECT_THAT(unknown.message, HasSubstr("77"));

  const Status duplicate = duplicate_body_status(88, "in two places");
  EXPECT_EQ(duplicate.code, StatusCode::duplicate_body);
  EXPECT_EQ(duplicate.body, 88U);
  EXPECT_THAT(duplicate.message, testing::AllOf(HasSubstr("88"), HasSubstr("in two places")));
}

TEST(FindDuplicate, FindsNothingWhereAllDiffer) {
  EXPECT_EQ(find_duplicate({}), std::nullopt);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{3}), std::nullopt);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{1, 2, 3}), std::nullopt);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{3, 0xffffffff, 0, 2}), std::nullopt);
}

TEST(FindDuplicate, FindsTheSmallestIdThatOccursTwice) {
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{5, 5}), 5U);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{1, 2, 2}), 2U);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{0, 1, 2, 0}), 0U);
  EXPECT_EQ(find_duplicate(std::vector<BodyId>{9, 4, 9, 0xffffffff, 4, 0xffffffff}), 4U);
}

}  // namespace
}  // namespace cellsweep
