/// @file
/// Bodies that do not meet all others: pairs exist where categories meet masks and not both bodies are
/// static, and a changed filter is a change like a move.
#include <gmock/gmock.h>

#include <numeric>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr BodyFilter kStatic{.is_static = true};
constexpr BodyFilter kNothing{.category = 1, .mask = 0};

Aabb unit_cube_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

class FilterContract : public PerEngine {
 protected:
  CheckedEngine checked_{GetParam(), testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_P(FilterContract, CategoriesMustMeetMasksBothWays) {
  const std::vector<Aabb> boxes(4, unit_cube_at(0));
  const BodyFilter shot{.category = 2, .mask = 1};
  const BodyFilter ghost{.category = 4, .mask = 0xffffffff};
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4}, boxes, {{}, shot, shot, ghost}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{1, 2}, Pair{1, 3}, Pair{1, 4}));
  EXPECT_EQ(checked_.engine().filter(2), shot);
  EXPECT_EQ(checked_.engine().filter(1), BodyFilter{});
  EXPECT_EQ(checked_.engine().filter(5), std::nullopt);
}

TEST_P(FilterContract, StaticBodiesMeetTheOthersOnly) {
  const std::vector<Aabb> boxes(4, unit_cube_at(0));
  ASSERT_TRUE(checked_.insert({1, 2, 3, 4}, boxes, {kStatic, kStatic, {}, {}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(),
              ElementsAre(Pair{1, 3}, Pair{1, 4}, Pair{2, 3}, Pair{2, 4}, Pair{3, 4}));
}

// Bodies that were there before anybody had a filter.
TEST_P(FilterContract, AChangedFilterBeginsAndEndsPairsWithoutAMove) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, std::vector<Aabb>(3, unit_cube_at(0))));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.set_filters({2}, {kNothing}));
  EXPECT_EQ(checked_.engine().filter(2), kNothing);
  EXPECT_THAT(checked_.engine().pairs(), testing::SizeIs(3)) << "until the next update";
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  ASSERT_TRUE(checked_.set_filters({2, 1}, {BodyFilter{}, kStatic}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  EXPECT_THAT(checked_.answer().ended, IsEmpty()) << "1 and 3 may still meet";
}

TEST_P(FilterContract, AChangeThatIsTakenBackIsNone) {
  ASSERT_TRUE(checked_.insert({1, 2}, std::vector<Aabb>(2, unit_cube_at(0))));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.set_filters({1}, {kNothing}));
  ASSERT_TRUE(checked_.set_filters({1}, {BodyFilter{}}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().began, IsEmpty());
  EXPECT_THAT(checked_.answer().ended, IsEmpty());
  ASSERT_TRUE(checked_.set_filters({1, 1, 1}, {kNothing, kStatic, kNothing})) << "the last counts";
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}));
}

TEST_P(FilterContract, AFilterGoesWithAMoveAndARemovalOfTheSameUpdate) {
  ASSERT_TRUE(checked_.insert({1, 2, 3}, {unit_cube_at(0), unit_cube_at(0), unit_cube_at(9)}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.move({3}, {unit_cube_at(0.5F)}));
  ASSERT_TRUE(checked_.set_filters({3, 1}, {kStatic, kStatic}));
  ASSERT_TRUE(checked_.move({1}, {unit_cube_at(0.25F)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{1, 2}, Pair{2, 3}));
  ASSERT_TRUE(checked_.set_filters({2}, {kNothing}));
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.insert({2}, {unit_cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.answer().ended, ElementsAre(Pair{1, 2}, Pair{2, 3})) << "another body of that id";
  EXPECT_THAT(checked_.answer().began, ElementsAre(Pair{1, 2}, Pair{2, 3}));
  EXPECT_EQ(checked_.engine().filter(2), BodyFilter{}) << "with the default";
}

TEST_P(FilterContract, ABodyTakesNoFilterFromOneThatWasInItsPlace) {
  ASSERT_TRUE(checked_.insert({1, 2}, std::vector<Aabb>(2, unit_cube_at(0)), {{}, kNothing}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.remove({2}));
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.insert({7}, {unit_cube_at(0)}));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(), ElementsAre(Pair{1, 7}));
}

TEST_P(FilterContract, ALevelMayBeMadeStaticAfterTheFact) {
  const std::size_t count = std::min<std::size_t>(60, checked_.capacity());
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(unit_cube_at(0.5F * static_cast<float>(i)));
  ASSERT_TRUE(checked_.insert(ids, boxes));
  ASSERT_TRUE(checked_.update());
  const std::vector<BodyId> level(ids.begin() + 3, ids.end());
  ASSERT_TRUE(checked_.set_filters(level, std::vector<BodyFilter>(level.size(), kStatic)));
  ASSERT_TRUE(checked_.update());
  EXPECT_THAT(checked_.engine().pairs(),
              ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}, Pair{1, 3}, Pair{2, 3}, Pair{2, 4}));
  ASSERT_TRUE(checked_.move({0}, {boxes.back()}));
  ASSERT_TRUE(checked_.update());
}

TEST_P(FilterContract, WhatIsWrongIsRefusedWhole) {
  ASSERT_TRUE(checked_.insert({1, 2}, std::vector<Aabb>(2, unit_cube_at(0))));
  ASSERT_TRUE(checked_.update());
  Status status;
  ASSERT_TRUE(checked_.refuse(
      [](Broadphase& engine) {
        return engine.set_filters(std::vector<BodyId>{1, 9}, std::vector<BodyFilter>{kNothing, kNothing});
      },
      status));
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  EXPECT_THAT(status.bodies, ElementsAre(9U));
  const auto one_filter = [](Broadphase& engine) {
    return engine.set_filters(std::vector<BodyId>{1, 2}, std::vector<BodyFilter>{kNothing});
  };
  ASSERT_TRUE(checked_.refuse(one_filter, status));
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, HasSubstr("2 ids but 1 filters"));
  const auto too_many = [](Broadphase& engine) {
    return engine.insert(std::vector<BodyId>{5}, std::vector<Aabb>{unit_cube_at(0)},
                         std::vector<BodyFilter>{kNothing, kNothing});
  };
  ASSERT_TRUE(checked_.refuse(too_many, status));
  EXPECT_EQ(status.code, StatusCode::bad_input);
  ASSERT_TRUE(checked_.update());
}

INSTANTIATE_TEST_SUITE_P(Engines, FilterContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
