/// @file
/// The boxes that are handed out: canonical, and those of the last update.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

/// A box with edge 1 whose lower corner is at (x, 0, 0).
using BoxesContract = PerEngine;

TEST_P(BoxesContract, TheyAreWhatWasGivenMadeCanonical) {
  Broadphase engine = make(GetParam());
  ASSERT_TRUE(engine.insert(4, {{-kSmallest, -0.0F, 1}, {2, kSmallest, 3}}).ok());
  ASSERT_TRUE(engine.update().ok());
  Aabb box;
  ASSERT_TRUE(engine.boxes(std::vector<BodyId>{4}, std::span(&box, 1)).ok());
  EXPECT_EQ(box, (Aabb{{0, 0, 1}, {2, 0, 3}}));
  for (const float zero : {box.min[0], box.min[1], box.max[1]}) EXPECT_FALSE(std::signbit(zero));
}

TEST_P(BoxesContract, TheyComeInTheOrderOfTheIdsWhichMayRepeat) {
  Broadphase engine = make(GetParam());
  ASSERT_TRUE(engine
                  .insert(std::vector<BodyId>{9, 0xffffffff, 0},
                          std::vector<Aabb>{cube_at(1), cube_at(2), cube_at(3)})
                  .ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(5);
  ASSERT_TRUE(engine.boxes(std::vector<BodyId>{0, 9, 0, 0xffffffff, 9}, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(cube_at(3), cube_at(1), cube_at(3), cube_at(2), cube_at(1)));
}

TEST_P(BoxesContract, TheyAreThoseOfTheLastUpdate) {
  Broadphase engine = make(GetParam());
  const std::vector<BodyId> ids = {1, 2};
  std::vector<Aabb> boxes(2);
  ASSERT_TRUE(engine.insert(ids, std::vector<Aabb>{cube_at(1), cube_at(2)}).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.move(1, cube_at(5)).ok());
  ASSERT_TRUE(engine.move(1, cube_at(6)).ok());
  ASSERT_TRUE(engine.remove(2).ok());
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(cube_at(1), cube_at(2)));
  ASSERT_TRUE(engine.insert(2, cube_at(7)).ok());
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(cube_at(1), cube_at(2))) << "the body that comes back is another one";
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(cube_at(6), cube_at(7)));
}

TEST_P(BoxesContract, ABodyThatNoUpdateHasSeenHasNone) {
  Broadphase engine = make(GetParam());
  ASSERT_TRUE(engine.insert(std::vector<BodyId>{1, 2}, std::vector<Aabb>(2, cube_at(1))).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.insert(3, cube_at(3)).ok());
  ASSERT_TRUE(engine.remove(2).ok());
  std::vector<Aabb> boxes(4, cube_at(77));
  Status status = engine.boxes(std::vector<BodyId>{1, 3, 2, 900}, boxes);
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  EXPECT_THAT(status.bodies, ElementsAre(3U, 900U));
  EXPECT_EQ(status.body, 3U);
  EXPECT_EQ(status.number, 2U);
  EXPECT_THAT(status.message, testing::AllOf(HasSubstr("3"), HasSubstr("900")));
  EXPECT_THAT(boxes, testing::Each(cube_at(77))) << "a refused call wrote boxes";
  ASSERT_TRUE(engine.update().ok());
  status = engine.boxes(std::vector<BodyId>{1, 3, 2, 1}, boxes);
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  EXPECT_THAT(status.bodies, ElementsAre(2U)) << "the update took it away";
}

TEST_P(BoxesContract, ManyThatAreUnknownAreNamedUpToSixteenAndCountedAll) {
  Broadphase engine = make(GetParam());
  ASSERT_TRUE(engine.insert(1000, cube_at(1)).ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<BodyId> ids(40);
  std::iota(ids.begin(), ids.end(), BodyId{990});
  std::vector<Aabb> boxes(ids.size());
  const Status status = engine.boxes(ids, boxes);
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  std::erase(ids, 1000U);
  EXPECT_EQ(status.number, ids.size());
  EXPECT_EQ(status.bodies, std::vector<BodyId>(ids.begin(), ids.begin() + Status::kMostBodies));
}

TEST_P(BoxesContract, EveryIdNeedsAPlaceAndEveryPlaceAnId) {
  Broadphase engine = make(GetParam());
  const std::vector<BodyId> ids = {1, 2};
  ASSERT_TRUE(engine.insert(ids, std::vector<Aabb>(2, cube_at(1))).ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(3);
  for (const std::size_t places : {0U, 1U, 3U}) {
    EXPECT_EQ(engine.boxes(ids, std::span(boxes).first(places)).code, StatusCode::bad_input) << places;
  }
  EXPECT_EQ(engine.boxes({}, std::span(boxes).first(1)).code, StatusCode::bad_input);
  EXPECT_TRUE(engine.boxes({}, {}).ok());
}

INSTANTIATE_TEST_SUITE_P(Engines, BoxesContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
