/// @file
/// cell-paper as an engine: its options, what `literal` loses, and what happens when an SPE cannot work.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "base/sanitized.h"
#include "cellsweep/world/scene.h"
#include "engines/cell/cell_world.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::cell {
namespace {

using testing::HasSubstr;

Aabb cube_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Overlaps every other such box on the axes y and z, with no value equal to another's.
Aabb box_on_x(float low, float high, float offset) {
  return {{low, offset, offset}, {high, offset + 10, offset + 10}};
}

std::vector<Pair> pairs_after_update(Broadphase& engine) {
  EXPECT_TRUE(engine.update().ok());
  return {engine.pairs().begin(), engine.pairs().end()};
}

TEST(CellPaper, TakesMethods1And2Only) {
  for (const unsigned method : {0U, 3U, 77U}) {
    const Status status = make_broadphase(CellPaperOptions{.method = method}).status();
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "method");
  }
}

TEST(CellPaper, RefusesALocalStoreThatCodeAndStackDoNotFitInto) {
  for (const std::uint64_t bytes : {std::uint64_t{1}, std::uint64_t{4096}, std::uint64_t{256 * 1024 + 1}}) {
    const Status status = make_broadphase(CellPaperOptions{.spes = {.local_store = bytes}}).status();
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "local_store");
  }
}

TEST(CellPaper, RefusesALocalStoreWithoutRoomForOneBody) {
  const Status status = make_broadphase(CellPaperOptions{.spes = {.local_store = 80 << 10}}).status();
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "local_store");
  EXPECT_THAT(status.message, HasSubstr("cannot hold a single body"));
}

TEST(CellPaper, RefusesAPairMapWithoutRoomForAPair) {
  const Status status = make_broadphase(CellPaperOptions{.pair_map_bytes = 63}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "pair_map_bytes");
  EXPECT_EQ(make(CellPaperOptions{.pair_map_bytes = 64}).capacity().setting, "pair_map_bytes");
}

TEST(CellPaper, RefusesATraceFileThatCannotBeWritten) {
  const Status status = make_broadphase(CellPaperOptions{.trace = "/nonexistent/trace.json"}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "trace");
}

TEST(CellPaper, WritesATimelineWhenTheLastEngineOfAFileGoes) {
  CellPaperOptions options;
  options.trace = testing::TempDir() + "/cell_paper_trace.json";
  {
    Broadphase first = make(options);
    Broadphase second = make(options);
    for (Broadphase* engine : {&first, &second}) {
      ASSERT_TRUE(engine->insert(1, cube_at(0)).ok());
      ASSERT_TRUE(engine->update().ok());
    }
  }
  std::stringstream text;
  text << std::ifstream(options.trace).rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("traceEvents"));
  EXPECT_THAT(text.str(), HasSubstr("PPU, cell-paper"));
  std::remove(options.trace.c_str());
}

TEST(CellPaper, RefusesMoreThanTheLocalStoreHoldsWithTheMap) {
  Broadphase engine = make(CellPaperOptions{.spes = {.local_store = 112 * 1024}});
  const Capacity capacity = engine.capacity();
  EXPECT_EQ(capacity.setting, "local_store");
  const std::vector<BodyId> ids = ids_up_to(static_cast<std::size_t>(capacity.bodies) + 1);
  const Status status = engine.insert(ids, std::vector<Aabb>(ids.size()));
  EXPECT_EQ(status.code, StatusCode::capacity);
  for (const char* part : {"code", "stack", "values", "keys", "too many", "114688"}) {
    EXPECT_THAT(status.message, HasSubstr(part));
  }
}

TEST(CellPaper, UsesNoMoreLocalStoreThanItsMapSays) {
  if (kIsSanitized) GTEST_SKIP() << "a sanitizer's data count too";
  for (const unsigned method : {1U, 2U}) {
    for (const bool list_dma : {false, true}) {
      const CellPaperOptions options{.method = method, .list_dma = list_dma};
      Broadphase engine = make(options);
      for (BodyId id = 0; id < 333; ++id)
        ASSERT_TRUE(engine.insert(id, cube_at(static_cast<float>(id))).ok());
      ASSERT_TRUE(engine.update().ok());
      const std::uint64_t high_water = cell_statistics(engine)->local_store_high_water;
      const auto map = local_store_map(options, 333);
      ASSERT_TRUE(map.ok());
      EXPECT_GT(high_water, 0U);
      EXPECT_LE(high_water, map->used());
    }
  }
}

TEST(CellPaper, LiteralLosesABoxInsideAnotherWhenItPassesAThird) {
  for (const bool literal : {false, true}) {
    Broadphase engine = make(CellPaperOptions{.literal = literal});
    ASSERT_TRUE(engine.insert(1, box_on_x(-9, 9, 0)).ok());
    ASSERT_TRUE(engine.insert(2, box_on_x(0, 1, 1)).ok());
    ASSERT_TRUE(engine.insert(3, box_on_x(2, 3, 2)).ok());
    EXPECT_THAT(pairs_after_update(engine), testing::SizeIs(2));
    // Bodies 2 and 3 change, body 1 does not: their earlier overlaps with it are cleared, and the walks
    // between their own ends do not meet it.
    ASSERT_TRUE(engine.move(2, box_on_x(4, 5, 1)).ok());
    EXPECT_THAT(pairs_after_update(engine), testing::SizeIs(literal ? 0 : 2));
  }
}

TEST(CellPaper, LiteralMissesATouchThatBegins) {
  for (const bool literal : {false, true}) {
    Broadphase engine = make(CellPaperOptions{.literal = literal});
    ASSERT_TRUE(engine.insert(1, cube_at(5)).ok());
    ASSERT_TRUE(engine.insert(2, cube_at(0)).ok());
    ASSERT_TRUE(engine.update().ok());
    ASSERT_TRUE(engine.move(2, cube_at(4)).ok());
    EXPECT_EQ(pairs_after_update(engine).size(), literal ? 0U : 1U);
  }
}

/// Pairs of the oracle that an engine misses in the frames of a scene.
std::size_t missed_pairs(const CellPaperOptions& options) {
  const auto source =
      std::move(*make_scene_frames(SceneSettings{.scene = "varied", .bodies = 100, .moving = 0.5}));
  Broadphase engine = make(options);
  EXPECT_TRUE(insert_all(engine, *source).ok());
  std::size_t missed = 0;
  for (int frame = 0; frame < 20; ++frame) {
    const std::vector<Pair> found = pairs_after_update(engine);
    const std::vector<Pair> truth = brute_force_pairs(source->boxes());
    for (const Pair& pair : truth) missed += std::ranges::binary_search(found, pair) ? 0 : 1;
    if (!options.literal) {
      EXPECT_EQ(found, truth) << "frame " << frame;
    }
    source->advance();
    EXPECT_TRUE(move_changed(engine, *source).ok());
  }
  return missed;
}

TEST(CellPaper, LiteralMissesWhatTheOracleFinds) {
  EXPECT_GT(missed_pairs({.literal = true}), 0U);
  EXPECT_EQ(missed_pairs({}), 0U);
}

}  // namespace
}  // namespace cellsweep::cell
