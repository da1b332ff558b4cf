#include "cellsweep/world/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scene_probe.h"

namespace cellsweep {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

World scene_of(const std::string& name, std::size_t bodies, std::uint64_t seed = 1) {
  SceneSettings settings;
  settings.scene = name;
  settings.bodies = bodies;
  settings.seed = seed;
  Result<World> world = make_scene(settings);
  EXPECT_TRUE(world.ok()) << world.status().message;
  return *world;
}

float world_edge(const std::string& name, std::size_t bodies) {
  return scene_of(name, bodies).bounds().max[0];
}

TEST(Scene, TheTableNamesTheScenesAndSaysWhatTheyAre) {
  std::vector<std::string> names;
  for (const SceneInfo& info : scene_table()) {
    names.emplace_back(info.name);
    EXPECT_FALSE(info.summary.empty()) << info.name;
  }
  EXPECT_THAT(names,
              ElementsAre("uniform", "varied", "clustered", "wall", "touch", "paper", "level", "bullets",
                          "swarm", "sleepers", "dust", "axis", "stacks", "pile", "ragdolls", "open-world"));
}

TEST(Scene, AnUnknownNameIsRefusedWithTheNamesThereAre) {
  SceneSettings settings;
  settings.scene = "heap";
  const Status status = make_scene(settings).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_THAT(status.message, HasSubstr("'heap'"));
  for (const SceneInfo& info : scene_table()) EXPECT_THAT(status.message, HasSubstr(std::string(info.name)));
}

TEST(Scene, ASettingOutOfRangeIsRefusedWithItsNameValueAndRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto expect_refused = [](const SceneSettings& settings, const std::string& setting,
                                 const std::string& value, const std::string& range) {
    for (const Status& status : {make_scene(settings).status(), make_scene_frames(settings).status()}) {
      EXPECT_EQ(status.code, StatusCode::bad_option);
      EXPECT_THAT(status.message, AllOf(HasSubstr(setting), HasSubstr(value), HasSubstr(range)));
    }
  };
  expect_refused({.moving = -0.25}, "moving", "-0.25", "0 to 1");
  expect_refused({.moving = 1.5}, "moving", "1.5", "0 to 1");
  expect_refused({.moving = std::nan("")}, "moving", "nan", "0 to 1");
  expect_refused({.speed = -1}, "speed", "-1", "0 to 1,000,000");
  expect_refused({.speed = 2e6}, "speed", "2e+06", "0 to 1,000,000");
  expect_refused({.speed = kInfinity}, "speed", "inf", "0 to 1,000,000");
  expect_refused({.speed = std::nan("")}, "speed", "nan", "0 to 1,000,000");
  expect_refused({.scene = "sleepers", .moving = 0.5}, "moving", "0.5", "'sleepers'");
  expect_refused({.scene = "stacks", .spinning = true}, "spinning", "on", "'stacks'");
  expect_refused({.bodies = (std::size_t{1} << 32) + 1}, "bodies", "4294967297", "0 to 4294967296");
}

TEST(Scene, AScriptIsNoWorldAndSaysWhereItsFramesAre) {
  const Status status = make_scene({.scene = "ragdolls"}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_THAT(status.message, AllOf(HasSubstr("'ragdolls'"), HasSubstr("make_scene_frames")));
  EXPECT_TRUE(make_scene_frames({.scene = "ragdolls"}).ok());
}

TEST(Scene, BoundsAreThoseOfItsWorldOrOfItsScript) {
  EXPECT_EQ(*scene_bounds({.scene = "wall"}), scene_of("wall", 1024).bounds());
  EXPECT_EQ(*scene_bounds({.scene = "stacks", .bodies = 40}), (Aabb{{0, 0, 0}, {2.5F, 10, 2.5F}}));
  EXPECT_FALSE(scene_bounds({.scene = "heap"}).ok());
}

TEST(Scene, EveryBoxIsInsideTheWorldAtFrameZero) {
  for (const SceneInfo& info : scene_table()) {
    if (!info.is_world) continue;
    for (const std::size_t bodies : {0, 1, 2, 3, 17, 18, 100, 1000, 5000}) {
      for (const std::uint64_t seed : {0U, 1U, 77U}) {
        const World world = scene_of(std::string(info.name), bodies, seed);
        ASSERT_EQ(world.size(), bodies);
        for (const RigidBody& body : world.bodies()) {
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_GE(body.box.min[axis], 0) << info.name;
            ASSERT_LE(body.box.max[axis], world.bounds().max[axis]) << info.name;
          }
        }
      }
    }
  }
}

TEST(Scene, WorldsGrowWithTheirBodiesAsEachSceneSays) {
  EXPECT_FLOAT_EQ(world_edge("uniform", 8000), 40);
  EXPECT_EQ(world_edge("uniform", 10), 12);
  EXPECT_FLOAT_EQ(world_edge("varied", 1000), std::cbrt(284800.0F));
  EXPECT_EQ(world_edge("varied", 10), 40);
  EXPECT_FLOAT_EQ(world_edge("clustered", 1000), std::sqrt(720.0F));
  EXPECT_EQ(world_edge("clustered", 10), 12);
  EXPECT_FLOAT_EQ(world_edge("wall", 8000), 40);
  EXPECT_EQ(world_edge("touch", 27), 3);
  EXPECT_EQ(world_edge("touch", 28), 4);
  EXPECT_EQ(world_edge("paper", 64), 20);
  EXPECT_EQ(world_edge("paper", 5000), 20);
}

TEST(Scene, EverySceneHasItsDensityOfPairs) {
  struct Density {
    std::string scene;
    double pairs;  ///< mean over seeds at 1,000 bodies
  };
  constexpr int kSeeds = 20;
  for (const Density& density : std::vector<Density>{
           {"uniform", 538}, {"paper", 538}, {"varied", 550}, {"clustered", 1070}, {"wall", 663}}) {
    double sum = 0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      sum += static_cast<double>(test::count_pairs(test::boxes_of(scene_of(density.scene, 1000, seed))));
    }
    EXPECT_NEAR(sum / kSeeds, density.pairs, 0.05 * density.pairs) << density.scene;
  }
}

TEST(Scene, TouchIsALatticeInWhichAllNeighboursTouch) {
  for (const std::size_t side : {1U, 2U, 3U, 5U, 10U}) {
    const std::size_t bodies = side * side * side;
    const std::size_t reach = 3 * side - 2;  // ordered pairs of equal or neighbouring places on one axis
    const std::size_t pairs = (reach * reach * reach - bodies) / 2;
    EXPECT_EQ(test::count_pairs(test::boxes_of(scene_of("touch", bodies))), pairs) << side;
  }
}

TEST(Scene, AnUnfinishedTouchLatticeHasWholeCoordinatesAndOnlyMissesItsLastBodies) {
  const std::vector<Aabb> whole = test::boxes_of(scene_of("touch", 64));
  const std::vector<Aabb> part = test::boxes_of(scene_of("touch", 50));
  EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin()));
  for (const Aabb& box : whole) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(box.min[axis], std::floor(box.min[axis]));
      EXPECT_EQ(box.max[axis], box.min[axis] + 1);
    }
  }
}

TEST(Scene, VariedCubesAreSpreadEvenlyOverTheOrdersOfSize) {
  const World world = scene_of("varied", 10000);
  std::array<int, 4> quarters{};  // of the logarithm from 0.1 to 10
  for (const RigidBody& body : world.bodies()) {
    const float edge = 2 * body.half_extents[0];
    ASSERT_GE(edge, 0.1F);
    ASSERT_LE(edge, 10.0F);
    EXPECT_EQ(body.half_extents[0], body.half_extents[1]);
    EXPECT_EQ(body.half_extents[0], body.half_extents[2]);
    ++quarters[std::min(3, static_cast<int>(2 * (std::log10(edge) + 1)))];
  }
  for (const int bodies : quarters) EXPECT_NEAR(bodies, 2500, 200);
}

TEST(Scene, ClusteredPutsNineTenthsInALayerOnTheFloor) {
  const World world = scene_of("clustered", 10000);
  const auto low = std::count_if(world.bodies().begin(), world.bodies().end(),
                                 [](const RigidBody& body) { return body.box.max[1] <= 5; });
  const double strays = 1000 * 4.0 / (static_cast<double>(world.bounds().max[1]) - 1);
  EXPECT_NEAR(static_cast<double>(low), 9000 + strays, 120);
}

TEST(Scene, WallMakesOneBodyInAHundredASheetOfTenToFiftyPercentOfTheWorld) {
  const World world = scene_of("wall", 5000);
  const float edge = world.bounds().max[0];
  int sheets = 0;
  for (const RigidBody& body : world.bodies()) {
    std::array<float, 3> edges = {2 * body.half_extents[0], 2 * body.half_extents[1],
                                  2 * body.half_extents[2]};
    std::sort(edges.begin(), edges.end());
    EXPECT_EQ(edges[0], 1);
    if (edges[2] == 1) continue;
    ++sheets;
    EXPECT_GE(edges[1], 0.0999F * edge);
    EXPECT_LE(edges[2], 0.5001F * edge);
  }
  EXPECT_EQ(sheets, 50);
}

TEST(Scene, TheSameSeedGivesTheSameBoxesAndAnotherSeedOthers) {
  for (const SceneInfo& info : scene_table()) {
    const std::string name(info.name);
    const auto hash = [&](std::uint64_t seed) {
      auto frames = std::move(*make_scene_frames({.scene = name, .bodies = 100, .seed = seed}));
      EXPECT_TRUE(frames->advance());
      return test::bits_hash(frames->boxes());
    };
    EXPECT_EQ(hash(3), hash(3)) << name;
    EXPECT_NE(hash(3), hash(4)) << name;
  }
}

TEST(Scene, TouchIsTheSameLatticeWhateverItsSeed) {
  EXPECT_EQ(test::boxes_of(scene_of("touch", 100, 3)), test::boxes_of(scene_of("touch", 100, 4)));
}

TEST(Scene, FewerPaperBodiesAreTheFirstOfMore) {
  const std::vector<Aabb> few = test::boxes_of(scene_of("paper", 64));
  const std::vector<Aabb> many = test::boxes_of(scene_of("paper", 1024));
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(SceneFrames, GiveThePosesThatTheirBoxesEnclose) {
  auto frames = std::move(
      *make_scene_frames({.scene = "varied", .bodies = 50, .seed = 3, .moving = 0.5, .spinning = true}));
  const BodyPose before = frames->poses()[49];
  std::size_t turned = 0;
  for (int update = 0; update < 5; ++update) ASSERT_TRUE(frames->advance());
  ASSERT_EQ(frames->poses().size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    RigidBody body;
    const BodyPose& pose = frames->poses()[i];
    for (int k = 0; k < 3; ++k) {
      body.position[k] = pose.centre[k];
      body.half_extents[k] = pose.half_extents[k];
    }
    body.orientation = {pose.orientation[3], pose.orientation[0], pose.orientation[1], pose.orientation[2]};
    body.update_box();
    EXPECT_EQ(body.box, frames->boxes()[i]) << "body " << i;
    turned += pose.orientation[3] != 1 ? 1U : 0U;
  }
  EXPECT_EQ(turned, 25U);
  EXPECT_EQ(before.orientation, BodyPose{}.orientation) << "all stand straight at frame 0";
}

}  // namespace
}  // namespace cellsweep
