/// @file
/// Fat boxes: what they enclose, and how far they reach ahead.
#include "engines/stream/bodies/fat_box.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>

#include "contract/box_kinds.h"

namespace cellsweep::stream {
namespace {

constexpr Aabb kUnit = {{0, 0, 0}, {1, 1, 1}};

/// The unit cube so far along x.
Aabb unit_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

bool surrounds(const Aabb& hull, const Aabb& box) {
  bool enclosed = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    enclosed = enclosed && hull.min[axis] <= box.min[axis] && box.max[axis] <= hull.max[axis];
  return enclosed;
}

TEST(FatBox, OfABodyAtRestIsItsBox) {
  EXPECT_EQ(fat_box_of(kUnit, kUnit, {8}), kUnit);
  EXPECT_EQ(fat_box_of(unit_at(-5), unit_at(-5), {12}), unit_at(-5));
}

TEST(FatBox, ReachesWhereTheBodyIsGoing) {
  EXPECT_EQ(fat_box_of(kUnit, unit_at(0.0625F), {4}), (Aabb{{0.0625F, 0, 0}, {1.3125F, 1, 1}}));
  EXPECT_EQ(fat_box_of(unit_at(0.0625F), kUnit, {4}), (Aabb{{-0.25F, 0, 0}, {1, 1, 1}}));
}

TEST(FatBox, OfASlowBodyLastsForLongTheWayItGoes) {
  constexpr float kStep = 1.0F / 4096;
  const Outlook outlook = {.updates = 4, .least = 1.0F / 64};
  const Aabb fat = fat_box_of(kUnit, unit_at(kStep), outlook);
  EXPECT_EQ(fat, (Aabb{{kStep, 0, 0}, {1 + kStep + 1.0F / 64, 1, 1}}));
  EXPECT_EQ(fat_box_of(unit_at(kStep), kUnit, outlook), (Aabb{{-1.0F / 64, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(fat_box_of(kUnit, unit_at(kStep), {4}), (Aabb{{kStep, 0, 0}, {1 + 5 * kStep, 1, 1}}))
      << "as far as it goes where no more is asked for";
}

TEST(FatBox, EnclosesTheBodyAsLongAsItKeepsItsCourse) {
  const Aabb fat = fat_box_of(kUnit, unit_at(0.0625F), {4});
  for (int update = 0; update <= 4; ++update)
    EXPECT_TRUE(surrounds(fat, unit_at(0.0625F + 0.0625F * static_cast<float>(update)))) << update;
  EXPECT_FALSE(surrounds(fat, unit_at(0.0625F * 6)));
}

TEST(FatBox, GrowsWithABoxThatGrows) {
  const Aabb larger = {{-0.0625F, 0, 0}, {1.0625F, 1, 1}};
  const Aabb fat = fat_box_of(kUnit, larger, {2});
  EXPECT_EQ(fat, (Aabb{{-0.1875F, 0, 0}, {1.1875F, 1, 1}}));
  EXPECT_EQ(fat_box_of(larger, kUnit, {2}), kUnit) << "and not with one that shrinks";
}

TEST(FatBox, GrowsByItsLengthAtMost) {
  EXPECT_EQ(fat_box_of(kUnit, unit_at(0.5F), {8}), (Aabb{{0.5F, 0, 0}, {2.5F, 1, 1}}));
  EXPECT_EQ(fat_box_of(kUnit, unit_at(-1), {8}), (Aabb{{-2, 0, 0}, {0, 1, 1}}));
}

// Three steps of an eighth to the edge of a fat box that has room for them.
TEST(FatBox, MayHaveBeenLeftOnACourseInAsManyUpdatesAsTheStepsTake) {
  const Aabb fat = {{0, 0, 0}, {1.375F, 1, 1}};
  EXPECT_TRUE(may_have_kept_course(fat, unit_at(0.375F), unit_at(0.5F), 4));
  EXPECT_FALSE(may_have_kept_course(fat, unit_at(0.375F), unit_at(0.5F), 5));
  EXPECT_FALSE(may_have_kept_course(fat, unit_at(0.375F), unit_at(0.5F), 1)) << "it began elsewhere";
  const Aabb to_the_side = {{0.5F, 0.125F, 0}, {1.5F, 1.125F, 1}};
  EXPECT_FALSE(may_have_kept_course(fat, unit_at(0.375F), to_the_side, 4)) << "there was no room";
}

TEST(Course, IsTheWayOfABodyButNotTooFar) {
  constexpr float kStep = 1.0F / 4096;
  EXPECT_EQ(course_of(kUnit, kUnit, 8), kUnit);
  EXPECT_EQ(course_of(kUnit, unit_at(kStep), 8), (Aabb{{kStep, 0, 0}, {1 + 9 * kStep, 1, 1}}));
  EXPECT_EQ(course_of(kUnit, unit_at(-0.25F), 8), (Aabb{{-1.25F, 0, 0}, {0.75F, 1, 1}}));
  EXPECT_EQ(course_of(kUnit, unit_at(1.5F), 8), unit_at(1.5F));
}

TEST(FatBox, OfABodyThatJumpsFurtherThanItsLengthIsItsBox) {
  EXPECT_EQ(fat_box_of(kUnit, unit_at(1.5F), {8}), unit_at(1.5F));
  EXPECT_EQ(fat_box_of(kUnit, unit_at(1e30F), {8}), unit_at(1e30F));
  const Aabb point = {{3, 3, 3}, {3, 3, 3}};
  EXPECT_EQ(fat_box_of(kUnit, point, {8}), point);
}

TEST(FatBox, OfABodyThatMayTurnReachesAsFarToEitherSide) {
  const Aabb fat = fat_box_of(kUnit, unit_at(0.0078125F), {.updates = 8, .may_turn = true});
  EXPECT_EQ(fat, (Aabb{{0.0078125F - 0.0625F, 0, 0}, {1.0078125F + 0.0625F, 1, 1}}));
  EXPECT_EQ(fat_box_of(kUnit, unit_at(0.25F), {.updates = 8, .may_turn = true}),
            (Aabb{{0.25F - 0.125F, 0, 0}, {2.25F, 1, 1}}))
      << "by an eighth of its length at most";
  EXPECT_EQ(fat_box_of(kUnit, kUnit, {.updates = 8, .may_turn = true}), kUnit);
}

TEST(FatBox, OfABodyThatMayTurnReachesSoManyLengthsAtLeast) {
  EXPECT_EQ(fat_box_of(kUnit, kUnit, {.updates = 8, .may_turn = true, .reach = 0.0625F}),
            (Aabb{{-0.0625F, -0.0625F, -0.0625F}, {1.0625F, 1.0625F, 1.0625F}}));
  EXPECT_EQ(fat_box_of(kUnit, kUnit, {.updates = 8, .reach = 0.0625F}), kUnit) << "and others do not";
}

TEST(FatBox, MayBeForLater) {
  const Aabb fat = later_fat_box_of(kUnit, unit_at(0.0625F), {.from = 2, .updates = 4});
  constexpr float kSlack = 1.0F / 256;
  EXPECT_EQ(fat, (Aabb{{0.1875F - kSlack, -kSlack, -kSlack}, {1.4375F + kSlack, 1 + kSlack, 1 + kSlack}}));
  for (int update = 0; update < 9; ++update) {
    const bool is_meant = update >= 2 && update <= 6;
    EXPECT_EQ(surrounds(fat, unit_at(0.0625F + 0.0625F * static_cast<float>(update))), is_meant) << update;
  }
}

TEST(FatBox, ForLaterLastsForLongWhereTheBodyIsSlow) {
  constexpr float kStep = 1.0F / 4096;
  constexpr float kSlack = 1.0F / 256;
  const Aabb fat = later_fat_box_of(kUnit, unit_at(kStep), {.from = 2, .updates = 4, .least = 1.0F / 16});
  EXPECT_EQ(fat, (Aabb{{3 * kStep - kSlack, -kSlack, -kSlack},
                       {1 + 3 * kStep + 1.0F / 16 + kSlack, 1 + kSlack, 1 + kSlack}}));
}

TEST(FatBox, OfABoxThatShrinksToNothingIsABox) {
  const Aabb fat = later_fat_box_of(kUnit, {{0.25F, 0, 0}, {0.75F, 1, 1}}, {.from = 8, .updates = 8});
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LE(fat.min[axis], fat.max[axis]);
}

TEST(FatBox, OfABodyThatJumpsIsNotCarriedAhead) {
  EXPECT_TRUE(surrounds(later_fat_box_of(kUnit, unit_at(1.5F), {.from = 8, .updates = 8}), unit_at(1.5F)));
}

TEST(FatBox, IsMadeForAStepInLengthsOfTheBox) {
  EXPECT_EQ(step_in_lengths(kUnit, unit_at(-0.25F)), 0.25F);
  EXPECT_EQ(step_in_lengths(kUnit, Aabb{{0, 0, 0}, {1, 2, 1}}), 0.5F) << "on the axis where it is most";
  EXPECT_EQ(step_in_lengths(kUnit, kUnit), 0);
  const Aabb point = {{3, 3, 3}, {3, 3, 3}};
  EXPECT_GT(step_in_lengths(kUnit, point), 1e6F);
  EXPECT_EQ(step_in_lengths(point, point), 0);
}

TEST(FatBox, HasTheMarginOnAllSidesWhateverTheBodyDoes) {
  const Aabb wide = {{-0.25F, -0.25F, -0.25F}, {1.25F, 1.25F, 1.25F}};
  EXPECT_EQ(fat_box_of(kUnit, kUnit, {.updates = 8, .margin = 0.25F}), wide);
  EXPECT_EQ(fat_box_of(unit_at(-50), kUnit, {.updates = 8, .margin = 0.25F}), wide);
  EXPECT_EQ(fat_box_of(unit_at(-0.125F), kUnit, {.updates = 4, .margin = 0.25F}),
            (Aabb{{-0.25F, -0.25F, -0.25F}, {1.5F, 1.25F, 1.25F}}));
}

TEST(FatBox, StaysWithinTheNumbersThereAre) {
  const Aabb all = {{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb corner = {{FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb half = {{0, 0, 0}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb other_half = {{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {0, 0, 0}};
  for (const Aabb& old : {all, corner, half, other_half, kUnit}) {
    for (const Aabb& now : {all, corner, half, other_half, kUnit}) {
      for (const float margin : {0.0F, 1.0F, 1e30F}) {
        const Aabb fat =
            fat_box_of(old, now, {.updates = 12, .may_turn = true, .margin = margin, .least = 0.125F});
        EXPECT_TRUE(surrounds(fat, now));
        EXPECT_TRUE(surrounds(all, fat));
        const Aabb later = later_fat_box_of(old, now, {.from = 7, .updates = 12, .margin = margin});
        EXPECT_TRUE(surrounds(all, later));
        for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LE(later.min[axis], later.max[axis]);
      }
    }
  }
}

TEST(FatBox, EnclosesTheBoxWhateverItWasBefore) {
  contract::Random random(1);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    const std::vector<Aabb> boxes = make_boxes(kind, random, 40);
    for (const Aabb& old : boxes) {
      for (const Aabb& given : boxes) {
        const Aabb now = contract::next_box(kind, random, old, given);
        for (const float updates : {4.0F, 8.0F, 12.0F}) {
          const Aabb fat = fat_box_of(old, now, {updates});
          ASSERT_TRUE(surrounds(fat, now)) << kind;
          for (std::size_t axis = 0; axis < 3; ++axis)
            ASSERT_TRUE(std::isfinite(fat.max[axis] / 2 - fat.min[axis] / 2));
        }
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::stream
