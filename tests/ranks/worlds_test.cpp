// The union of what all ranks say is what one engine says, in every world.
#include <gtest/gtest.h>

#include <random>

#include "cellsweep/engines.h"
#include "cellsweep/world/scene.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

constexpr std::size_t kBodies = 300;

// Bodies go to all ranks in turn; those who own them move them.
void hand_over(Twins& twins, const FrameSource& source, bool first) {
  const int ranks = all_ranks();
  const auto of = [&](std::span<const BodyId> ids, int rank, bool owned) {
    std::vector<BodyId> mine;
    for (const BodyId id : ids) {
      if (owned || static_cast<int>(id) % ranks == rank) mine.push_back(id);
    }
    return mine;
  };
  for (int rank = 0; rank < ranks; ++rank) {
    const auto inserted = of(first ? source.bodies() : source.inserted(), rank, false);
    std::vector<Aabb> boxes;
    std::vector<BodyFilter> filters;
    for (const BodyId id : inserted) {
      boxes.push_back(source.boxes()[id]);
      if (!source.filters().empty()) filters.push_back(source.filters()[id]);
    }
    twins.insert(rank, inserted, boxes, filters);
    const auto removed = of(source.removed(), rank, false);
    twins.remove(rank, removed);
    const auto moved = of(source.moved(), rank, false);
    boxes.clear();
    for (const BodyId id : moved) boxes.push_back(source.boxes()[id]);
    twins.move(rank, moved, boxes);
  }
}

std::string run(const SceneSettings& settings, int frames, const RankOptions& options = {}) {
  Twins twins(options);
  const auto source = make_scene_frames(settings);
  hand_over(twins, **source, true);
  for (int frame = 0; frame < frames; ++frame) {
    if (const std::string words = twins.update_and_compare(); !words.empty())
      return "frame " + std::to_string(frame) + ": " + words;
    if (!(*source)->advance()) break;
    hand_over(twins, **source, false);
  }
  return {};
}

TEST(DistributedBroadphase, SaysWhatOneEngineSaysInEveryScene) {
  for (const SceneInfo& scene : scene_table())
    EXPECT_EQ(run({.scene = std::string(scene.name), .bodies = kBodies}, 12), "") << scene.name;
}

TEST(DistributedBroadphase, SaysItWhereverAGiantIs) {
  for (const GiantSlot giant : {GiantSlot::first, GiantSlot::last})
    EXPECT_EQ(run({.scene = "uniform", .bodies = kBodies, .moving = 1.0, .giant = giant}, 8), "");
}

TEST(DistributedBroadphase, SaysItWhenBodiesFlyThroughSeveralRegionsAFrame) {
  EXPECT_EQ(run({.scene = "uniform", .bodies = kBodies, .moving = 1.0, .speed = 300}, 12), "");
}

TEST(DistributedBroadphase, SaysItWhenTheWorldIsCutAnewEachFrame) {
  EXPECT_EQ(run({.scene = "uniform", .bodies = kBodies, .moving = 1.0, .speed = 30, .groups = 3}, 12,
                {.recut_every = 1}),
            "");
}

TEST(DistributedBroadphase, SaysItWithEveryEngineOfTheTable) {
  for (const EngineInfo& engine : engine_table()) {
    RankOptions options;
    options.make_engine = [&] { return engine.make({}); };
    EXPECT_EQ(run({.scene = "varied", .bodies = 150, .moving = 1.0, .speed = 20}, 6, options), "")
        << engine.name;
  }
}

}  // namespace
}  // namespace cellsweep::ranks
