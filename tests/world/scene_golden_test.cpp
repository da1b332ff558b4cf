#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/world/scene.h"
#include "scene_probe.h"

namespace cellsweep {
namespace {

/// Every bit of every box of 500 bodies with seed 7, all moving. The same for every compiler, optimisation
/// and machine (W4); a change here changes every recorded result of the project.
struct Golden {
  std::string scene;
  std::string frame_0;
  std::string frame_100;
  std::string frame_100_spinning;
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.scene;
}

std::string hash_after(int updates, const std::string& scene, bool spinning) {
  auto frames =
      make_scene_frames({.scene = scene, .bodies = 500, .seed = 7, .moving = 1, .spinning = spinning});
  EXPECT_TRUE(frames.ok()) << frames.status().message;
  for (int update = 0; update < updates; ++update) EXPECT_TRUE((*frames)->advance());
  return hash_text(test::bits_hash((*frames)->boxes()));
}

class SceneBits : public ::testing::TestWithParam<Golden> {};

TEST_P(SceneBits, AreTheSameEverywhere) {
  const Golden& golden = GetParam();
  EXPECT_EQ(hash_after(0, golden.scene, false), golden.frame_0);
  EXPECT_EQ(hash_after(0, golden.scene, true), golden.frame_0);
  EXPECT_EQ(hash_after(100, golden.scene, false), golden.frame_100);
  EXPECT_EQ(hash_after(100, golden.scene, true), golden.frame_100_spinning);
}

INSTANTIATE_TEST_SUITE_P(
    EveryScene, SceneBits,
    ::testing::Values(Golden{"uniform", "98ceb1b18d94410c", "4c083dc9d32b68bf", "b0dc57ebf9c8fd7d"},
                      Golden{"varied", "df1cbf1611ecb5b4", "863f8d628302ed0e", "ce28293806a3d165"},
                      Golden{"clustered", "2827f5d319112ad3", "149f67f7759123ef", "9d2989e96197684a"},
                      Golden{"wall", "1cbb0645a18b96e3", "76fb6a76b172a35a", "8032cd37e1043d4c"},
                      Golden{"touch", "175901aeb3ec072d", "2f1028f6e33ec7e3", "8d83261c05997417"},
                      Golden{"paper", "d2be93a3e6ed40d0", "477f9a306590a9e5", "5de3332b51d865e2"}),
    [](const auto& test) { return test.param.scene; });

/// As above, of the scenes whose bodies follow a script, or move as the scene says.
TEST(SceneBits, OfScenesWithAMotionOfTheirOwnAreTheSameEverywhere) {
  const auto hash_of = [](const std::string& scene) {
    auto frames = std::move(*make_scene_frames({.scene = scene, .bodies = 500, .seed = 7}));
    for (int update = 0; update < 100; ++update) EXPECT_TRUE(frames->advance());
    std::vector<Aabb> boxes;
    for (const BodyId id : frames->bodies()) boxes.push_back(frames->boxes()[id]);
    return hash_text(test::bits_hash(boxes));
  };
  EXPECT_EQ(hash_of("level"), "00db3297f57f448e");
  EXPECT_EQ(hash_of("bullets"), "360a1376f2517a93");
  EXPECT_EQ(hash_of("swarm"), "45bc7c90f660170e");
  EXPECT_EQ(hash_of("sleepers"), "31ecfac0db214309");
  EXPECT_EQ(hash_of("dust"), "aef0b98e2eae37a3");
  EXPECT_EQ(hash_of("axis"), "8f8135d8cb020547");
  EXPECT_EQ(hash_of("stacks"), "ad1617ec24d0f7d5");
  EXPECT_EQ(hash_of("pile"), "fb6817640e1e7fd1");
  EXPECT_EQ(hash_of("ragdolls"), "ce7614d86a21e245");
  EXPECT_EQ(hash_of("open-world"), "ddad2aca0dbf51cc");
}

}  // namespace
}  // namespace cellsweep
