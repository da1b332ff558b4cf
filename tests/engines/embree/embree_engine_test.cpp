/// @file
/// Engine `embree` behind the handle: its changes, when it builds a tree, its settings.
#include "cellsweep/embree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cellsweep/engines.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Aabb cube(float at) {
  return {{at, at, at}, {at + 1, at + 1, at + 1}};
}

std::uint64_t trees_built(const Broadphase& engine) {
  return std::ranges::find(engine.statistics().counters, "trees built", &Counter::name)->value;
}

class Embree : public testing::Test {
 protected:
  Embree() {
    EXPECT_TRUE(
        engine_.insert(std::vector<BodyId>{7, 3, 5}, std::vector<Aabb>{cube(0), cube(1), cube(2)}).ok());
  }

  Broadphase engine_ = std::move(*make_broadphase(EmbreeOptions{.threads = 2}));
};

TEST_F(Embree, TellsWhatBeganAndEnded) {
  EXPECT_EQ(engine_.name(), "embree");
  EXPECT_THAT(engine_.update()->began, ElementsAre(Pair{3, 5}, Pair{3, 7}));
  ASSERT_TRUE(engine_.move(7, cube(1.5F)).ok());
  const auto changes = engine_.update();
  EXPECT_THAT(changes->began, ElementsAre(Pair{5, 7}));
  EXPECT_THAT(changes->ended, IsEmpty());
  EXPECT_THAT(engine_.pairs(), ElementsAre(Pair{3, 5}, Pair{3, 7}, Pair{5, 7}));
}

TEST_F(Embree, EndsThePairsOfBodiesThatGo) {
  ASSERT_TRUE(engine_.update().ok());
  ASSERT_TRUE(engine_.remove(std::vector<BodyId>{3}).ok());
  EXPECT_THAT(engine_.update()->ended, ElementsAre(Pair{3, 5}, Pair{3, 7}));
  ASSERT_TRUE(engine_.insert(3, cube(2)).ok());
  EXPECT_THAT(engine_.update()->began, ElementsAre(Pair{3, 5}));
  ASSERT_TRUE(engine_.remove(std::vector<BodyId>{3, 7}).ok());
  EXPECT_THAT(engine_.update()->ended, ElementsAre(Pair{3, 5})) << "one body is left";
  EXPECT_THAT(engine_.pairs(), IsEmpty());
}

TEST_F(Embree, BuildsATreeOnlyWhenSomethingChanged) {
  ASSERT_TRUE(engine_.update().ok());
  EXPECT_EQ(trees_built(engine_), 1U);
  const auto changes = engine_.update();
  EXPECT_TRUE(changes->began.empty() && changes->ended.empty());
  EXPECT_EQ(trees_built(engine_), 1U);
  EXPECT_EQ(engine_.pairs().size(), 2U);
  EXPECT_GT(engine_.statistics().bytes, 0U);
}

TEST(EmbreeInTheTable, HasSettingsByName) {
  add_embree_engine();
  const EngineInfo* info = find_engine("embree");
  ASSERT_NE(info, nullptr);
  EXPECT_EQ(info->settings.size(), 2U);
  EXPECT_TRUE(make_broadphase("embree", {{"threads", "1"}}).ok());
  EXPECT_EQ(make_broadphase("embree", {{"threads", "-1"}}).status().setting, "threads");
  EXPECT_EQ(make_broadphase("embree", {{"isa", "avx2"}}).status().setting, "isa");
  EXPECT_EQ(make_broadphase("embree", {{"trace", "/nonexistent/trace.json"}}).status().setting, "trace");
}

}  // namespace
}  // namespace cellsweep
