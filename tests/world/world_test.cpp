#include "cellsweep/world/world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "scene_probe.h"
#include "world/random.h"

namespace cellsweep {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Aabb kBounds = {{0, 0, 0}, {10, 20, 30}};

RigidBody cube_at(float x, float y, float z) {
  RigidBody body;
  body.position = {x, y, z};
  return body;
}

RigidBody flying(RigidBody body, const Eigen::Vector3f& velocity) {
  body.dynamic = true;
  body.velocity = velocity;
  return body;
}

TEST(World, NamesBodiesInTheOrderTheyCameAndNeverUsesANameTwice) {
  World world(kBounds);
  EXPECT_EQ(world.add(cube_at(1, 1, 1)), 0U);
  EXPECT_EQ(world.add(cube_at(2, 2, 2)), 1U);
  EXPECT_EQ(world.add(cube_at(3, 3, 3)), 2U);
  EXPECT_TRUE(world.remove(2).ok());
  EXPECT_TRUE(world.remove(0).ok());
  EXPECT_EQ(world.add(cube_at(4, 4, 4)), 3U);

  EXPECT_EQ(world.size(), 2U);
  EXPECT_THAT(world.ids(), ElementsAre(1, 3));
  EXPECT_EQ(world.bodies()[0].position.x(), 2);
  EXPECT_EQ(world.bodies()[1].position.x(), 4);
}

TEST(World, FindsBodiesByIdAndNoneThatIsGone) {
  World world(kBounds);
  for (int i = 0; i < 10; ++i) world.add(cube_at(static_cast<float>(i), 1, 1));
  for (const BodyId id : {0U, 4U, 9U}) ASSERT_TRUE(world.remove(id).ok());
  const World& read_only = world;
  for (BodyId id = 0; id < 12; ++id) {
    const bool gone = id == 0 || id == 4 || id >= 9;
    ASSERT_EQ(world.find(id) == nullptr, gone) << id;
    EXPECT_EQ(read_only.find(id), world.find(id));
    if (gone) continue;
    EXPECT_EQ(world.find(id)->position.x(), static_cast<float>(id));
  }
}

TEST(World, RefusesToRemoveABodyItDoesNotHave) {
  World world(kBounds);
  world.add(cube_at(1, 1, 1));
  const Status status = world.remove(7);
  EXPECT_EQ(status.code, StatusCode::unknown_body);
  EXPECT_EQ(status.body, BodyId{7});
  EXPECT_THAT(status.message, HasSubstr("7"));
  EXPECT_EQ(world.size(), 1U);
}

TEST(World, BringsTheBoxOfAnAddedBodyUpToDate) {
  World world(kBounds);
  const BodyId id = world.add(cube_at(5, 6, 7));
  EXPECT_EQ(world.find(id)->box, (Aabb{{4.5F, 5.5F, 6.5F}, {5.5F, 6.5F, 7.5F}}));
}

TEST(World, ABodyPastAnyOfTheSixPlanesAndMovingOutwardsTurnsBackOnThatAxisOnly) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      World world(kBounds);
      RigidBody body = flying(cube_at(5, 10, 15), {0.125F, 0.125F, 0.125F});
      body.position[axis] = side < 0 ? 0.25F : kBounds.max[axis] - 0.25F;
      body.velocity[axis] = side * 0.125F;
      world.add(body);
      world.step();
      for (int k = 0; k < 3; ++k) {
        const float expected = k == axis ? -body.velocity[k] : body.velocity[k];
        EXPECT_EQ(world.bodies()[0].velocity[k], expected)
            << "plane " << axis << ' ' << side << " axis " << k;
        EXPECT_EQ(world.bodies()[0].position[k], body.position[k] + expected);
      }
    }
  }
}

TEST(World, ABodyOutsideThatMovesInwardsIsNotTurned) {
  World world(kBounds);
  world.add(flying(cube_at(-50, 200, 15), {0.5F, -0.5F, 0}));
  for (int frame = 0; frame < 50; ++frame) {
    world.step();
    EXPECT_EQ(world.bodies()[0].velocity, Eigen::Vector3f(0.5F, -0.5F, 0));
  }
  EXPECT_EQ(world.bodies()[0].position, Eigen::Vector3f(-25, 175, 15));
}

TEST(World, ABodyThatTouchesAPlaneHasNotPassedIt) {
  World world(kBounds);
  world.add(flying(cube_at(9.5F, 5, 5), {0.25F, 0, 0}));
  world.step();
  EXPECT_EQ(world.bodies()[0].velocity.x(), 0.25F);
  world.step();
  EXPECT_EQ(world.bodies()[0].velocity.x(), -0.25F);
  EXPECT_EQ(world.bodies()[0].position.x(), 9.5F);
}

TEST(World, ABodyBiggerThanTheWorldStaysWhereItIsToWithinOneStep) {
  World world(kBounds);
  RigidBody giant = flying(cube_at(5, 10, 15), {0.25F, -0.5F, 1});
  giant.half_extents = {100, 100, 100};
  world.add(giant);
  for (int frame = 0; frame < 1001; ++frame) {
    world.step();
    for (int axis = 0; axis < 3; ++axis) {
      const float distance = world.bodies()[0].position[axis] - giant.position[axis];
      ASSERT_LE(std::abs(distance), std::abs(giant.velocity[axis])) << "frame " << frame << " axis " << axis;
    }
  }
}

TEST(World, ABodyThatIsNotDynamicNeverMoves) {
  World world(kBounds);
  RigidBody body = cube_at(5, 5, 5);
  body.velocity = {1, 1, 1};
  body.angular_velocity = {1, 1, 1};
  world.add(body);
  const Aabb before = world.bodies()[0].box;
  world.step();
  EXPECT_EQ(world.bodies()[0].box, before);
  EXPECT_THAT(world.moved(), IsEmpty());
}

TEST(World, ABodyTurnsAboutTheWorldsAxesByItsAngularVelocity) {
  constexpr double kTurn = 0.01;
  constexpr int kFrames = 150;
  World world(kBounds);
  RigidBody body = flying(cube_at(5, 5, 5), {0, 0, 0});
  body.orientation = Eigen::AngleAxisf(1.0F, Eigen::Vector3f::UnitX());
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 3).normalized();
  body.angular_velocity = (axis * kTurn).cast<float>();
  world.add(body);
  for (int frame = 0; frame < kFrames; ++frame) world.step();

  const Eigen::Quaterniond turned = world.bodies()[0].orientation.cast<double>();
  const Eigen::Quaterniond expected =
      Eigen::AngleAxisd(kTurn * kFrames, axis) * body.orientation.cast<double>();
  EXPECT_NEAR(turned.norm(), 1, 1e-6);
  EXPECT_LT(turned.angularDistance(expected), 1e-4);
}

TEST(World, ASpinningBodysQuaternionKeepsItsLengthAndItsBoxGrowsAndShrinks) {
  World world(kBounds);
  RigidBody body = flying(cube_at(5, 5, 5), {0, 0, 0});
  body.angular_velocity = {0.1F, 0.05F, -0.02F};
  world.add(body);
  float widest = 0;
  float narrowest = 10;
  for (int frame = 0; frame < 2000; ++frame) {
    world.step();
    const RigidBody& now = world.bodies()[0];
    ASSERT_NEAR(now.orientation.norm(), 1, 1e-6) << frame;
    widest = std::max(widest, now.box.max[0] - now.box.min[0]);
    narrowest = std::min(narrowest, now.box.max[0] - now.box.min[0]);
  }
  EXPECT_GT(widest, 1.4F);
  EXPECT_LT(widest, 1.7321F);
  EXPECT_LT(narrowest, 1.1F);
  EXPECT_GT(narrowest, 0.9999F);
}

TEST(World, MovedNamesExactlyTheBodiesWhoseBoxChanged) {
  World world(kBounds);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    RigidBody body = cube_at(5, 5, 5);
    for (int axis = 0; axis < 3; ++axis) body.position[axis] = static_cast<float>(random.between(1, 9));
    body.dynamic = random.below(2) == 0;
    // Speeds from one that changes every box to one that is lost when it is added to a position.
    const double speed = 0x1p-18 * random.unit() * random.unit() * random.unit();
    if (random.below(3) != 0) body.velocity.x() = static_cast<float>(speed);
    if (random.below(10) == 0) body.angular_velocity.y() = 0.1F;
    world.add(body);
  }
  for (BodyId id = 0; id < 200; id += 7) ASSERT_TRUE(world.remove(id).ok());

  std::size_t moved = 0;
  std::size_t dynamic_still = 0;
  for (int frame = 0; frame < 50; ++frame) {
    const std::vector<Aabb> before = test::boxes_of(world);
    world.step();
    const std::vector<Aabb> after = test::boxes_of(world);
    std::vector<BodyId> changed;
    for (std::size_t i = 0; i < world.size(); ++i) {
      const bool differs = std::memcmp(&before[i], &after[i], sizeof(Aabb)) != 0;
      if (differs) changed.push_back(world.ids()[i]);
      if (!differs && world.bodies()[i].dynamic) ++dynamic_still;
    }
    ASSERT_EQ(std::vector<BodyId>(world.moved().begin(), world.moved().end()), changed) << frame;
    moved += changed.size();
  }
  EXPECT_GT(moved, 0U);
  EXPECT_GT(dynamic_still, 0U) << "no dynamic body was too slow to change its box: the test shows too little";
}

TEST(World, MovedForgetsABodyThatIsRemoved) {
  World world(kBounds);
  for (int i = 1; i < 5; ++i) world.add(flying(cube_at(static_cast<float>(i), 5, 5), {0.1F, 0, 0}));
  world.step();
  EXPECT_THAT(world.moved(), ElementsAre(0, 1, 2, 3));
  ASSERT_TRUE(world.remove(2).ok());
  EXPECT_THAT(world.moved(), ElementsAre(0, 1, 3));
  world.step();
  EXPECT_THAT(world.moved(), ElementsAre(0, 1, 3));
}

TEST(World, BodiesInAPairWearTheCollidingColourAndAllOthersThePlainOne) {
  const WorldColors colors{.plain = {0.1F, 0.2F, 0.3F}, .colliding = {0.9F, 0.8F, 0.7F}};
  World world(kBounds, colors);
  for (int i = 0; i < 5; ++i) world.add(cube_at(1, 1, 1));
  const auto worn = [&] {
    std::string text;
    for (const RigidBody& body : world.bodies()) {
      text += body.color == colors.plain ? 'p' : body.color == colors.colliding ? 'c' : '?';
    }
    return text;
  };
  EXPECT_EQ(worn(), "ppppp");
  world.color_collisions(std::vector<Pair>{{0, 3}, {3, 4}});
  EXPECT_EQ(worn(), "cppcc");
  world.color_collisions(std::vector<Pair>{{1, 3}});
  EXPECT_EQ(worn(), "pcpcp");
  ASSERT_TRUE(world.remove(3).ok());
  world.color_collisions(std::vector<Pair>{{1, 3}});
  EXPECT_EQ(worn(), "pcpp");
  world.color_collisions({});
  EXPECT_EQ(worn(), "pppp");
}

}  // namespace
}  // namespace cellsweep
