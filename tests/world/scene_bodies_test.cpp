#include "world/scenes/scene_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cellsweep {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Aabb kHere{{0, 0, 0}, {1, 1, 1}};
constexpr Aabb kThere{{5, 0, 0}, {6, 1, 1}};
constexpr Aabb kLarge{{-9, -9, -9}, {9, 9, 9}};

TEST(SceneBodies, KnowWhoIsThereAndWhatChangedInTheFrame) {
  SceneBodies bodies(3, std::nullopt, {});
  for (const BodyId id : {0U, 1U, 2U}) bodies.insert(id, kHere);
  bodies.end_frame();
  EXPECT_THAT(bodies.bodies(), ElementsAre(0, 1, 2));

  bodies.begin_frame();
  bodies.move(0, kHere);
  bodies.move(1, kThere);
  bodies.remove(2);
  bodies.end_frame();
  EXPECT_THAT(bodies.bodies(), ElementsAre(0, 1));
  EXPECT_THAT(bodies.moved(), ElementsAre(1)) << "a body that stays where it is has not moved";
  EXPECT_THAT(bodies.removed(), ElementsAre(2));
  EXPECT_THAT(bodies.inserted(), IsEmpty());
  EXPECT_EQ(bodies.boxes()[1], kThere);

  bodies.begin_frame();
  bodies.insert(2, kThere);
  bodies.end_frame();
  EXPECT_THAT(bodies.bodies(), ElementsAre(0, 1, 2));
  EXPECT_THAT(bodies.inserted(), ElementsAre(2));
  EXPECT_THAT(bodies.moved(), IsEmpty());
}

TEST(SceneBodies, LeaveTheGiantAsItIs) {
  SceneBodies bodies(2, BodyId{1}, kLarge);
  for (const BodyId id : {0U, 1U}) bodies.insert(id, kHere);
  bodies.end_frame();
  bodies.begin_frame();
  bodies.move(1, kThere);
  bodies.remove(1);
  bodies.end_frame();
  EXPECT_THAT(bodies.bodies(), ElementsAre(0, 1));
  EXPECT_THAT(bodies.moved(), IsEmpty());
  EXPECT_EQ(bodies.boxes()[1], kLarge);
}

}  // namespace
}  // namespace cellsweep
