/// @file
/// Between two updates calls are remembered and nothing shows; the update takes them together.
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A box with edge 1 whose lower corner is at (x, 0, 0).
/// Short cases on one engine. Besides, each call checks that pairs() and boxes() stay those of the last
/// update, and each update compares with the oracle.
class StagingContract : public PerEngine {
 protected:
  CheckedEngine checked_{GetParam(), testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_P(StagingContract, NoCallShowsBeforeTheNextUpdate) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(0.5F), cube_at(9)}));
  EXPECT_THAT(checked_.engine().pairs(), IsEmpty());
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.insert({4}, {cube_at(0)}));
  ASSERT_TRUE(checked_.move({3}, {cube_at(0)}));
  ASSERT_TRUE(checked_.remove({1}));
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{1, 2}));
  std::vector<Aabb> boxes(3);
  ASSERT_TRUE(checked_.engine().boxes(std::vector<BodyId>{1, 2, 3}, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(cube_at(0), cube_at(0.5F), cube_at(9)));
  EXPECT_TRUE(checked_.engine().contains(4));
  EXPECT_FALSE(checked_.engine().contains(1));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{2, 3}, Pair{2, 4}, Pair{3, 4}));
}

TEST_P(StagingContract, TheLastOfSeveralMovesCounts) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({2}, {cube_at(4)}));
  ASSERT_TRUE(checked_.move({2}, {cube_at(0)}));
  ASSERT_TRUE(checked_.move({2}, {cube_at(1)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, TheLastOfSeveralBoxesForABodyInOneCallCounts) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(9), cube_at(20)}));
  ASSERT_TRUE(checked_.move({2, 2}, {cube_at(1), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  ASSERT_TRUE(checked_.move({2, 3, 2, 2, 3}, {cube_at(5), cube_at(1), cube_at(9), cube_at(1), cube_at(20)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, ABodyThatMovedAwayAndBackDidNothing) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(0.5F), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({2}, {cube_at(9)}));
  ASSERT_TRUE(checked_.move({2}, {cube_at(0.5F)}));
  ASSERT_TRUE(checked_.move({1, 1}, {cube_at(30), cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  EXPECT_THAT(checked_.answer().ended, IsEmpty());
  EXPECT_THAT(checked_.answer().pairs, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, APairThatBeganAndEndedBetweenTwoUpdatesIsNotMentioned) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({2}, {cube_at(0)}));
  ASSERT_TRUE(checked_.move({2}, {cube_at(9)}));
  ASSERT_TRUE(checked_.insert({3}, {cube_at(0)}));
  ASSERT_TRUE(checked_.remove({3}));
  ASSERT_TRUE(checked_.update());
  EXPECT_EQ(checked_.answer(), Answer{});
}

TEST_P(StagingContract, ANewBodyMayMoveBeforeTheUpdate) {
  ASSERT_TRUE(checked_.insert({1}, {cube_at(0)}));
  ASSERT_TRUE(checked_.insert({2, 3}, {cube_at(9), cube_at(0)}));
  ASSERT_TRUE(checked_.move({2, 3}, {cube_at(0.5F), cube_at(20)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, ABodyThatNoUpdateSawLeavesNothingBehind) {
  ASSERT_TRUE(checked_.insert({1}, {cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(checked_.insert({2, 3}, {cube_at(0), cube_at(0)}));
    ASSERT_TRUE(checked_.move({3}, {cube_at(0.5F)}));
    ASSERT_TRUE(checked_.remove({3, 2}));
  }
  ASSERT_TRUE(checked_.update());
  EXPECT_EQ(checked_.answer(), Answer{});
  EXPECT_EQ(checked_.engine().size(), 1U);
}

TEST_P(StagingContract, BodiesThatNoUpdateSeesTakeNoMoreMemoryUpdateByUpdate) {
  ASSERT_TRUE(checked_.insert({1}, {cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  std::uint64_t bytes = 0;
  for (int round = 0; round < repeated(400, effort(400, 100, 100)); ++round) {
    ASSERT_TRUE(checked_.insert({2, 3, 4}, std::vector<Aabb>(3, cube_at(0))));
    ASSERT_TRUE(checked_.remove({2, 3, 4}));
    ASSERT_TRUE(checked_.update());
    if (round == 20) bytes = checked_.engine().statistics().bytes;
  }
  EXPECT_EQ(checked_.engine().statistics().bytes, bytes);
}

TEST_P(StagingContract, ABodyThatNoUpdateSawMayComeBackElsewhere) {
  ASSERT_TRUE(checked_.insert({1}, {cube_at(0)}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(0)}));
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_EQ(checked_.answer(), Answer{});
  ASSERT_TRUE(checked_.move({2}, {cube_at(1)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, ABodyReplacedByOneWithTheSameIdAndBoxEndsItsPairsAndBeginsThem) {
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4}, {cube_at(0), cube_at(0.5F), cube_at(0.75F), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  EXPECT_THAT(checked_.answer().pairs, ElementsAre(Pair{1, 2}, Pair{1, 3}, Pair{2, 3}));
}

TEST_P(StagingContract, ABodyReplacedByOneWithTheSameIdElsewhereEndsOldPairsAndBeginsNewOnes) {
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4}, {cube_at(0), cube_at(0.5F), cube_at(1.5F), cube_at(2.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(2)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{2, 3}, Pair{2, 4}));
}

TEST_P(StagingContract, AReplacedBodyMayMoveToWhereTheOldOneWas) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({2}, {cube_at(9)}));
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(30)}));
  ASSERT_TRUE(checked_.move({2}, {cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, ABodyReplacedSeveralTimesEndsItsPairsOnce) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  for (const float x : {9.0F, 0.0F, 0.5F}) {
    ASSERT_TRUE(checked_.remove({1}));
    ASSERT_TRUE(checked_.insert({1}, {cube_at(x)}));
  }
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, ABodyReplacedAndThenRemovedJustEndsItsPairs) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {cube_at(0.5F)}));
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, IsEmpty());
}

TEST_P(StagingContract, ReplacedBodiesAndBodiesThatMoveDoNotGetInEachOthersWay) {
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4, 5},
                              {cube_at(0), cube_at(0.5F), cube_at(0.75F), cube_at(9), cube_at(9.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({1, 3}, {cube_at(9), cube_at(0.25F)}));
  ASSERT_TRUE(checked_.remove({2, 4}));
  ASSERT_TRUE(checked_.insert({4, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}, Pair{1, 3}, Pair{2, 3}, Pair{4, 5}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 5}, Pair{2, 3}, Pair{2, 4}, Pair{3, 4}));
}

TEST_P(StagingContract, TwoBodiesThatAreReplacedTogetherEndTheirPairAndBeginIt) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(0.5F), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2, 1}));
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0.5F), cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, AnIdMayBeUsedAgainLater) {
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(0), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({1}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.insert({1}, {cube_at(0.25F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}));
}

TEST_P(StagingContract, BodiesThatSwapTheirPlacesKeepTheirNames) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(0.5F), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({2, 3}, {cube_at(9), cube_at(0.5F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 3}));
}

TEST_P(StagingContract, PairsMayBeAskedForLateAndSeldom) {
  checked_.look_at_pairs(false);
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {cube_at(0), cube_at(0.5F), cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({3}, {cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({1}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({1, 2}, {cube_at(9), cube_at(9)}));
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{2, 3}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{1, 2}));
}

INSTANTIATE_TEST_SUITE_P(Engines, StagingContract, all_engines(), engine_label);

/// More bodies than the short cases have, so that engines which treat few changes and many apart do either.
class ManyStagedContract : public PerEngine {
 protected:
  ManyStagedContract() : random_(9), boxes_(make_boxes(kind_, random_, count())) {
    ids_.resize(boxes_.size());
    std::iota(ids_.begin(), ids_.end(), BodyId{0});
  }

  std::size_t count() const { return std::min<std::size_t>(effort(400, 200, 100), checked_.capacity()); }

  /// Replaces every n-th body by one of its id and its box.
  void replace(std::size_t every) {
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < ids_.size(); i += every) {
      ids.push_back(ids_[i]);
      boxes.push_back(checked_.model().boxes.at(ids_[i]));
    }
    ASSERT_TRUE(checked_.remove(ids));
    ASSERT_TRUE(checked_.insert(ids, boxes));
  }

  void move(std::size_t every) {
    std::vector<BodyId> ids;
    std::vector<Aabb> boxes;
    for (std::size_t i = 1; i < ids_.size(); i += every) {
      ids.push_back(ids_[i]);
      boxes.push_back(random_.pick(boxes_));
    }
    ASSERT_TRUE(checked_.move(ids, boxes));
  }

  const BoxKind& kind_ = box_kind("uniform");
  Random random_;
  CheckedEngine checked_{GetParam(), "many changes at a time"};
  std::vector<Aabb> boxes_;
  std::vector<BodyId> ids_;
};

TEST_P(ManyStagedContract, FewBodiesOrManyAreReplacedWhileFewOrManyMove) {
  ASSERT_TRUE(checked_.insert(ids_, boxes_));
  ASSERT_TRUE(checked_.update());
  for (const std::size_t replaced : {40, 1}) {
    for (const std::size_t moved : {1000, 30, 1}) {
      replace(replaced);
      move(moved);
      ASSERT_TRUE(checked_.update());
    }
    replace(replaced);
    const std::size_t pairs = checked_.model().pairs.size();
    ASSERT_TRUE(checked_.update());
    ASSERT_EQ(checked_.answer().pairs.size(), pairs);
    if (replaced == 1) {
      EXPECT_EQ(checked_.answer().began.size(), pairs) << "all bodies are new";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ManyStagedContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
