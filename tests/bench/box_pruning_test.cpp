#include "bench/peers/box_pruning.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cellsweep/world/scene.h"
#include "contract/box_kinds.h"
#include "report/oracle.h"

namespace cellsweep::bench {
namespace {

// All that this processor can run.
std::vector<Sweep> sweeps() {
  std::vector<Sweep> sweeps = {sweep_portable};
  if (best_sweep() != sweep_portable) sweeps.push_back(best_sweep());
  return sweeps;
}

void expect_exact(const std::vector<Aabb>& boxes, std::string_view name) {
  for (const Sweep sweep : sweeps()) {
    BoxPruning pruning(sweep);
    std::vector<Pair> pairs = {{1, 2}};
    pruning.find_pairs(boxes, pairs);
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, report::oracle_pairs(boxes)) << name;
  }
}

TEST(BoxPruning, EqualsAllAgainstAllOnEveryScene) {
  for (const SceneInfo& scene : scene_table()) {
    SceneSettings settings;
    settings.scene = scene.name;
    settings.bodies = 500;
    const auto source = std::move(*make_scene_frames(settings));
    expect_exact({source->boxes().begin(), source->boxes().end()}, scene.name);
  }
}

TEST(BoxPruning, EqualsAllAgainstAllOnEveryKindOfBoxesAndAnyCount) {
  contract::Random random(11);
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {0U, 1U, 2U, 7U, 8U, 9U, 100U}) {
      std::vector<Aabb> boxes = contract::make_boxes(kind, random, count);
      for (Aabb& box : boxes) box = contract::canonical_box(box);
      expect_exact(boxes, kind.name);
    }
  }
}

TEST(BoxPruning, ForgetsTheBoxesBefore) {
  BoxPruning pruning;
  std::vector<Pair> pairs;
  pruning.find_pairs(std::vector<Aabb>(20, Aabb{{0, 0, 0}, {1, 1, 1}}), pairs);
  EXPECT_EQ(pairs.size(), 190U);
  pruning.find_pairs(std::vector<Aabb>(3, Aabb{{-1, -1, -1}, {0, 0, 0}}), pairs);
  EXPECT_EQ(pairs.size(), 3U);
}

}  // namespace
}  // namespace cellsweep::bench
