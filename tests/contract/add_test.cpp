/// @file
/// Bodies whose ids the library hands out.
#include <gmock/gmock.h>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A box with edge 1 whose lower corner is at (x, 0, 0).
/// Short cases on one engine. Besides, every add() is checked to hand out ids that are small and free.
class AddContract : public PerEngine {
 protected:
  CheckedEngine checked_{GetParam(), testing::UnitTest::GetInstance()->current_test_info()->name()};
  std::vector<BodyId> ids_;
};

TEST_P(AddContract, IdsAreHandedOutFromZeroOn) {
  ASSERT_TRUE(checked_.add({cube_at(0), cube_at(0.5F), cube_at(9)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(0U, 1U, 2U));
  ASSERT_TRUE(checked_.add({cube_at(0.75F)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(3U));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{0, 1}, Pair{0, 3}, Pair{1, 3}));
  ASSERT_TRUE(checked_.add({cube_at(9)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(4U));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{2, 4}));
}

TEST_P(AddContract, NothingToAddIsNoError) {
  ASSERT_TRUE(checked_.add({}, ids_));
  ASSERT_TRUE(checked_.update());
  EXPECT_EQ(checked_.engine().size(), 0U);
}

TEST_P(AddContract, IdsThatTheCallerChoseAreLeftOut) {
  ASSERT_TRUE(checked_.insert({0, 2, 5, 0xffffffff}, std::vector<Aabb>(4, cube_at(0))));
  ASSERT_TRUE(checked_.add(std::vector<Aabb>(4, cube_at(9)), ids_));
  EXPECT_THAT(ids_, testing::Each(testing::Lt(16U)));
  ASSERT_TRUE(checked_.update());
}

TEST_P(AddContract, AnIdThatWasHandedOutIsTheCallersToUse) {
  ASSERT_TRUE(checked_.add({cube_at(0), cube_at(9)}, ids_));
  ASSERT_TRUE(checked_.move({1}, {cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{0, 1}));
  Status status;
  ASSERT_TRUE(checked_.refuse([](Broadphase& e) { return e.insert(1, cube_at(0)); }, status));
  EXPECT_EQ(status.code, StatusCode::duplicate_body);
  ASSERT_TRUE(checked_.insert({2}, {cube_at(0)}));
  ASSERT_TRUE(checked_.add({cube_at(0)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(3U));
  ASSERT_TRUE(checked_.remove({0, 1, 2, 3}));
  ASSERT_TRUE(checked_.update());
}

TEST_P(AddContract, AnIdIsNotUsedAgainBeforeTheEndOfItsPairsWasReported) {
  ASSERT_TRUE(checked_.add({cube_at(0), cube_at(0.5F), cube_at(9)}, ids_));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({0}));
  ASSERT_TRUE(checked_.add({cube_at(0)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(3U));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{0, 1}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 3}));
  ASSERT_TRUE(checked_.add({cube_at(0), cube_at(20)}, ids_));
  EXPECT_THAT(ids_, UnorderedElementsAre(0U, 4U));
  ASSERT_TRUE(checked_.update());
}

TEST_P(AddContract, AnIdThatNoUpdateSawIsFreeAfterTheNext) {
  ASSERT_TRUE(checked_.add({cube_at(0), cube_at(0)}, ids_));
  ASSERT_TRUE(checked_.remove({0}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  ASSERT_TRUE(checked_.add({cube_at(9)}, ids_));
  EXPECT_THAT(ids_, ElementsAre(0U));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
}

TEST_P(AddContract, IdsFillTheGapsThatBodiesLeft) {
  ASSERT_TRUE(checked_.add(std::vector<Aabb>(12, cube_at(0)), ids_));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({7, 3, 11, 10}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.insert({3}, {cube_at(5)}));
  ASSERT_TRUE(checked_.add(std::vector<Aabb>(3, cube_at(5)), ids_));
  EXPECT_THAT(ids_, UnorderedElementsAre(7U, 10U, 11U));
  ASSERT_TRUE(checked_.update());
}

TEST_P(AddContract, IdsAreSmallAgainWhenAllBodiesAreGone) {
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(checked_.add(std::vector<Aabb>(5, cube_at(0)), ids_));
    EXPECT_THAT(ids_, UnorderedElementsAre(0U, 1U, 2U, 3U, 4U));
    ASSERT_TRUE(checked_.update());
    EXPECT_EQ(checked_.answer().began.size(), 10U);
    ASSERT_TRUE(checked_.remove(ids_));
    ASSERT_TRUE(checked_.update());
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, AddContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
