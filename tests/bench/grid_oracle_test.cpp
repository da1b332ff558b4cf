#include "bench/peers/grid_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cellsweep/world/scene.h"
#include "contract/box_kinds.h"
#include "report/oracle.h"

namespace cellsweep::bench {
namespace {

std::vector<Pair> sorted_grid_pairs(const std::vector<Aabb>& boxes) {
  std::vector<Pair> pairs = grid_pairs(boxes);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(GridOracle, EqualsAllAgainstAllOnEveryScene) {
  for (const SceneInfo& scene : scene_table()) {
    SceneSettings settings;
    settings.scene = scene.name;
    settings.bodies = 700;
    const auto source = std::move(*make_scene_frames(settings));
    const std::vector<Aabb> boxes(source->boxes().begin(), source->boxes().end());
    EXPECT_EQ(sorted_grid_pairs(boxes), report::oracle_pairs(boxes)) << scene.name;
  }
}

TEST(GridOracle, EqualsAllAgainstAllBesideGiants) {
  for (const GiantSlot giant : {GiantSlot::first, GiantSlot::last}) {
    const auto source = std::move(*make_scene_frames({.scene = "dust", .bodies = 900, .giant = giant}));
    const std::vector<Aabb> boxes(source->boxes().begin(), source->boxes().end());
    EXPECT_EQ(sorted_grid_pairs(boxes), report::oracle_pairs(boxes));
  }
}

TEST(GridOracle, EqualsAllAgainstAllOnEveryKindOfBoxes) {
  contract::Random random(7);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    std::vector<Aabb> boxes = contract::make_boxes(kind, random, 200);
    for (Aabb& box : boxes) box = contract::canonical_box(box);
    EXPECT_EQ(sorted_grid_pairs(boxes), report::oracle_pairs(boxes)) << kind.name;
  }
}

TEST(GridOracle, FindsNothingAmongNoBoxesAndOne) {
  EXPECT_TRUE(grid_pairs({}).empty());
  const std::vector<Aabb> one = {{{0, 0, 0}, {1, 1, 1}}};
  EXPECT_TRUE(grid_pairs(one).empty());
}

TEST(GridOracle, FindsAPairOfPointsInOnePlace) {
  const std::vector<Aabb> points(2, Aabb{{3, 3, 3}, {3, 3, 3}});
  EXPECT_EQ(grid_pairs(points), (std::vector<Pair>{{0, 1}}));
}

}  // namespace
}  // namespace cellsweep::bench
