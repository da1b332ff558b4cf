#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <tuple>
#include <vector>

#include "cellsweep/world/scene.h"
#include "scene_probe.h"

namespace cellsweep {
namespace {

World make(const SceneSettings& settings) {
  Result<World> world = make_scene(settings);
  EXPECT_TRUE(world.ok()) << world.status().message;
  return *world;
}

std::vector<BodyId> movers(const World& world) {
  std::vector<BodyId> ids;
  for (const BodyId id : world.ids()) {
    if (world.find(id)->dynamic) ids.push_back(id);
  }
  return ids;
}

float shortest_edge(const RigidBody& body) {
  return 2 * body.half_extents.minCoeff();
}

TEST(SceneMotion, ExactlyTheRoundedShareOfTheBodiesMoves) {
  struct Share {
    std::size_t bodies;
    double moving;
    std::size_t movers;
  };
  for (const Share& share :
       {Share{0, 1, 0}, Share{1, 0.49, 0}, Share{1, 0.5, 1}, Share{3, 0.5, 2}, Share{1000, 0, 0},
        Share{1000, 0.1, 100}, Share{1024, 0.1, 102}, Share{1000, 0.3333, 333}, Share{1000, 1, 1000}}) {
    const World world = make({.bodies = share.bodies, .moving = share.moving});
    EXPECT_EQ(movers(world).size(), share.movers) << share.moving << " of " << share.bodies;
  }
}

TEST(SceneMotion, WhoMovesIsSpreadOverTheBodiesAndDependsOnTheSeed) {
  const std::vector<BodyId> one = movers(make({.bodies = 1000, .seed = 1, .moving = 0.2}));
  const std::vector<BodyId> other = movers(make({.bodies = 1000, .seed = 2, .moving = 0.2}));
  EXPECT_NE(one, other);
  const auto in_first_half = std::count_if(one.begin(), one.end(), [](BodyId id) { return id < 500; });
  EXPECT_NEAR(static_cast<double>(in_first_half), 100, 30);
}

TEST(SceneMotion, MoversOfASmallShareMoveInALargeOneToo) {
  const std::vector<BodyId> few = movers(make({.bodies = 1000, .moving = 0.1}));
  const std::vector<BodyId> many = movers(make({.bodies = 1000, .moving = 0.5}));
  EXPECT_TRUE(std::includes(many.begin(), many.end(), few.begin(), few.end()));
}

TEST(SceneMotion, FrameZeroIsTheSameWhoeverMovesAndHowever) {
  for (const std::string scene : test::kPlainScenes) {
    SceneSettings settings{.scene = scene, .bodies = 300, .moving = 0};
    const std::uint64_t still = test::bits_hash(test::boxes_of(make(settings)));
    for (const double moving : {0.1, 0.5, 1.0}) {
      for (const bool spinning : {false, true}) {
        settings.moving = moving;
        settings.spinning = spinning;
        settings.speed = moving * 3;
        EXPECT_EQ(test::bits_hash(test::boxes_of(make(settings))), still) << scene << ' ' << moving;
      }
    }
  }
}

TEST(SceneMotion, NobodyIsFasterThanATenthOfItsShortestEdgeAndNobodyStandsStill) {
  for (const std::string scene : test::kPlainScenes) {
    const World world = make({.scene = scene, .bodies = 2000, .moving = 1});
    double sum = 0;
    for (const RigidBody& body : world.bodies()) {
      const float share = body.velocity.norm() / (0.1F * shortest_edge(body));
      ASSERT_GT(share, 0) << scene;
      ASSERT_LE(share, 1.00001F) << scene;
      sum += static_cast<double>(share);
    }
    EXPECT_NEAR(sum / 2000, 0.5, 0.03) << scene;
  }
}

TEST(SceneMotion, DirectionsFavourNoSideAndNoCorner) {
  const World world = make({.bodies = 10000, .moving = 1});
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  double fourth_powers = 0;  // one fifth on a sphere, less when the corners of a cube are favoured
  for (const RigidBody& body : world.bodies()) {
    const Eigen::Vector3d direction = body.velocity.cast<double>().normalized();
    sum += direction;
    squares += direction.cwiseAbs2();
    fourth_powers += direction.cwiseAbs2().squaredNorm() / 3;
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum[axis] / 10000, 0, 0.03);
    EXPECT_NEAR(squares[axis] / 10000, 1.0 / 3, 0.02);
  }
  EXPECT_NEAR(fourth_powers / 10000, 0.2, 0.003);
}

TEST(SceneMotion, SpeedIsAFactorOnEveryVelocity) {
  const World normal = make({.bodies = 200, .moving = 1});
  const World twice = make({.bodies = 200, .moving = 1, .speed = 2});
  const World none = make({.bodies = 200, .moving = 1, .speed = 0});
  for (BodyId id = 0; id < 200; ++id) {
    EXPECT_EQ(twice.find(id)->velocity, 2 * normal.find(id)->velocity);
    EXPECT_EQ(none.find(id)->velocity, Eigen::Vector3f(0, 0, 0));
  }
}

TEST(SceneMotion, OnlyMoversSpinAndOnlyWhenAsked) {
  const World plain = make({.bodies = 1000, .moving = 0.5});
  const World spinning = make({.bodies = 1000, .moving = 0.5, .spinning = true});
  for (BodyId id = 0; id < 1000; ++id) {
    const RigidBody& body = *spinning.find(id);
    EXPECT_EQ(plain.find(id)->angular_velocity.norm(), 0);
    EXPECT_EQ(plain.find(id)->velocity, body.velocity);
    EXPECT_EQ(body.angular_velocity.norm() > 0, body.dynamic);
    EXPECT_LE(body.angular_velocity.norm(), 0.100001F);
  }
}

TEST(SceneMotion, NothingMovesWhenTheShareIsZero) {
  auto frames = make_scene_frames({.bodies = 500, .moving = 0, .spinning = true});
  ASSERT_TRUE(frames.ok());
  const std::uint64_t before = test::bits_hash((*frames)->boxes());
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_TRUE((*frames)->advance());
    EXPECT_TRUE((*frames)->moved().empty());
  }
  EXPECT_EQ(test::bits_hash((*frames)->boxes()), before);
}

TEST(SceneMotion, AllMoveWhenTheShareIsOne) {
  for (const std::string scene : test::kPlainScenes) {
    auto frames = make_scene_frames({.scene = scene, .bodies = 500, .moving = 1});
    ASSERT_TRUE(frames.ok());
    ASSERT_TRUE((*frames)->advance());
    EXPECT_EQ((*frames)->moved().size(), 500U) << scene;
  }
}

TEST(SceneMotion, FramesStandAtFrameZeroFirstAndCarryTheScenesName) {
  const SceneSettings settings{.scene = "wall", .bodies = 300, .moving = 1};
  auto frames = make_scene_frames(settings);
  ASSERT_TRUE(frames.ok());
  EXPECT_EQ((*frames)->name(), "wall");
  EXPECT_TRUE((*frames)->moved().empty());
  EXPECT_EQ(test::bits_hash((*frames)->boxes()), test::bits_hash(test::boxes_of(make(settings))));
}

TEST(SceneMotion, FramesFollowTheWorldAndNameExactlyTheChangedBoxes) {
  for (const bool spinning : {false, true}) {
    const SceneSettings settings{
        .scene = "varied", .bodies = 300, .moving = 0.4, .speed = 1e-5, .spinning = spinning};
    auto frames = make_scene_frames(settings);
    ASSERT_TRUE(frames.ok());
    World world = make(settings);
    for (int frame = 0; frame < 60; ++frame) {
      const std::vector<Aabb> before((*frames)->boxes().begin(), (*frames)->boxes().end());
      ASSERT_TRUE((*frames)->advance());
      world.step();
      const std::vector<Aabb> after((*frames)->boxes().begin(), (*frames)->boxes().end());
      ASSERT_EQ(after, test::boxes_of(world));
      std::vector<BodyId> changed;
      for (BodyId id = 0; id < 300; ++id) {
        if (std::memcmp(&before[id], &after[id], sizeof(Aabb)) != 0) changed.push_back(id);
      }
      ASSERT_EQ(std::vector<BodyId>((*frames)->moved().begin(), (*frames)->moved().end()), changed);
    }
  }
}

/// How far a body's box can get: past a plane by one step, and by what turning adds to its reach meanwhile.
Aabb farthest_reach(const RigidBody& body, const Aabb& bounds) {
  constexpr float kRounding = 1e-4F;
  const bool spins = body.angular_velocity.norm() > 0;
  const float growth = spins ? body.half_extents.norm() - body.half_extents.minCoeff() : 0;
  Aabb reach = bounds;
  for (int axis = 0; axis < 3; ++axis) {
    const float overshoot = std::abs(body.velocity[axis]) + growth + kRounding;
    reach.min[axis] -= overshoot;
    reach.max[axis] += overshoot;
  }
  return reach;
}

bool is_inside(const Aabb& inner, const Aabb& outer) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(inner.min[axis] >= outer.min[axis] && inner.max[axis] <= outer.max[axis])) return false;
  }
  return true;
}

class SceneBounds : public ::testing::TestWithParam<std::tuple<std::string, bool>> {};

TEST_P(SceneBounds, AreLeftByNobodyInTwoThousandFrames) {
  const auto& [scene, spinning] = GetParam();
  World world = make({.scene = scene, .bodies = 100, .moving = 1, .spinning = spinning});
  const World start = world;
  std::vector<Aabb> reaches;
  for (const RigidBody& body : start.bodies()) reaches.push_back(farthest_reach(body, start.bounds()));

  for (int frame = 0; frame < 2000; ++frame) {
    world.step();
    for (BodyId id = 0; id < 100; ++id) {
      ASSERT_TRUE(is_inside(world.bodies()[id].box, reaches[id])) << "body " << id << " frame " << frame;
    }
  }
  int turned = 0;
  for (const BodyId id : world.ids()) turned += world.find(id)->velocity != start.find(id)->velocity ? 1 : 0;
  EXPECT_GT(turned, 20) << "too few bodies met a plane for the test to show anything";
}

INSTANTIATE_TEST_SUITE_P(
    EveryScene, SceneBounds,
    ::testing::Combine(::testing::Values("uniform", "varied", "clustered", "wall", "touch", "paper"),
                       ::testing::Bool()),
    [](const auto& test) { return std::get<0>(test.param) + (std::get<1>(test.param) ? "Spinning" : ""); });

TEST(SceneMotion, EvenTheFastestBodiesStayFinite) {
  auto frames = make_scene_frames({.bodies = 100, .moving = 1, .speed = 1e6, .spinning = true});
  ASSERT_TRUE(frames.ok());
  for (int frame = 0; frame < 500; ++frame) ASSERT_TRUE((*frames)->advance());
  for (const Aabb& box : (*frames)->boxes()) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GT(box.min[axis], -2e5F);
      EXPECT_LT(box.max[axis], 2e5F);
    }
  }
}

}  // namespace
}  // namespace cellsweep
