/// @file
/// The small cases of the contract, each as a sentence: what a reader can check by hand.
#include <gmock/gmock.h>

#include <cfloat>
#include <limits>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kDenormal = std::numeric_limits<float>::denorm_min();

/// A box with edge 1 whose lower corner is at (x, 0, 0).
/// Short cases on one engine; update() and the calls compare with the oracle besides.
class EdgesContract : public PerEngine {
 protected:
  CheckedEngine checked_{GetParam(), testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_P(EdgesContract, ANewEngineHoldsNothing) {
  EXPECT_EQ(checked_.engine().size(), 0U);
  EXPECT_THAT(checked_.engine().pairs(), IsEmpty());
  EXPECT_EQ(checked_.engine().statistics().updates, 0U);
}

TEST_P(EdgesContract, AnEmptyEngineCanBeUpdated) {
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.update());
  EXPECT_EQ(checked_.answer(), Answer{});
}

TEST_P(EdgesContract, AnUpdateWithNothingInBetweenChangesNothing) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  EXPECT_THAT(checked_.answer().ended, IsEmpty());
  EXPECT_THAT(checked_.answer().pairs, ElementsAre(Pair{1, 2}));
}

TEST_P(EdgesContract, RemovingAllBodiesEndsAllPairs) {
  ASSERT_TRUE(checked_.insert({5, 6, 7}, {cube_at(0), cube_at(0.5F), cube_at(0.75F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({6, 7, 5}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{5, 6}, Pair{5, 7}, Pair{6, 7}));
  EXPECT_THAT(checked_.answer().pairs, IsEmpty());
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, IsEmpty());
}

TEST_P(EdgesContract, ABodyReplacedByAnotherIdInTheSamePlaceEndsOnePairAndBeginsOne) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({1}));
  ASSERT_TRUE(checked_.insert({3}, {cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{2, 3}));
}

TEST_P(EdgesContract, TouchingAtAFaceAnEdgeOrACornerCounts) {
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4}, {Aabb{{0, 0, 0}, {1, 1, 1}}, Aabb{{1, 0, 0}, {2, 1, 1}},
                                             Aabb{{-1, 1, 0}, {0, 2, 1}}, Aabb{{-1, -1, -1}, {0, 0, 0}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}, Pair{1, 3}, Pair{1, 4}));
}

TEST_P(EdgesContract, ATouchBeginsAndEndsWithOneBit) {
  const float apart = std::nextafter(1.0F, 2.0F);
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), Aabb{{apart, 0, 0}, {2, 1, 1}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  ASSERT_TRUE(checked_.move({2}, {Aabb{{1, 0, 0}, {2, 1, 1}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
  ASSERT_TRUE(checked_.move({2}, {Aabb{{apart, 0, 0}, {2, 1, 1}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
}

TEST_P(EdgesContract, ABoxInsideAnotherOverlapsItFromWhicheverSideItCame) {
  ASSERT_TRUE(checked_.insert({1, 2}, {Aabb{{-5, -5, -5}, {5, 5, 5}}, cube_at(90)}));
  ASSERT_TRUE(checked_.update());
  for (const float side : {90.0F, -90.0F}) {
    ASSERT_TRUE(checked_.move({2}, {cube_at(0)}));
    ASSERT_TRUE(checked_.update());
    EXPECT_THAT(checked_.answer().pairs, ElementsAre(Pair{1, 2}));
    ASSERT_TRUE(checked_.move({2}, {cube_at(side)}));
    ASSERT_TRUE(checked_.update());
    EXPECT_THAT(checked_.answer().pairs, IsEmpty());
  }
}

TEST_P(EdgesContract, MinusZeroAndDenormalsAreZero) {
  const Aabb below{{-1, -1, -1}, {-kDenormal, -0.0F, -kDenormal}};
  const Aabb above{{kDenormal, 0.0F, FLT_MIN - kDenormal}, {1, 1, 1}};
  ASSERT_TRUE(checked_.insert({1, 2}, {below, above}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(EdgesContract, TheSmallestNormalNumberIsNotZero) {
  ASSERT_TRUE(checked_.insert({1, 2}, {Aabb{{-1, 0, 0}, {0, 1, 1}}, Aabb{{FLT_MIN, 0, 0}, {1, 1, 1}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
}

TEST_P(EdgesContract, ABoxIsJudgedByItsCanonicalValues) {
  const Aabb wrong_way_round_by_a_denormal{{kDenormal, 0, 0}, {-kDenormal, 0, -0.0F}};
  ASSERT_TRUE(checked_.insert({1, 2}, {wrong_way_round_by_a_denormal, Aabb{}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(EdgesContract, TheLargestNumbersAreGoodBoxes) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {Aabb{{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}},
                                          Aabb{{FLT_MAX, FLT_MAX, FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}},
                                          Aabb{{-FLT_MAX, 0, 0}, {-FLT_MAX, 0, 0}}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}, Pair{1, 3}));
}

TEST_P(EdgesContract, IdsWithEqualHalvesAreDifferentBodies) {
  ASSERT_TRUE(checked_.insert({0x00010002, 0x00020002, 0x00020001, 0x80000002},
                              {cube_at(0), cube_at(0.5F), cube_at(30), cube_at(31)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began,
              ElementsAre(Pair{0x00010002, 0x00020002}, Pair{0x00020001, 0x80000002}));
}

TEST_P(EdgesContract, TheFirstAndTheLastIdAreGoodIds) {
  ASSERT_TRUE(checked_.insert({0xffffffff, 0}, {cube_at(0), cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{0, 0xffffffff}));
}

INSTANTIATE_TEST_SUITE_P(Engines, EdgesContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
