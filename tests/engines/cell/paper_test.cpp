/// @file
/// cell-paper as an engine: its options, what `literal` loses, and what happens when an SPE cannot work.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "cellsweep/engines.h"
#include "cellsweep/local_store.h"
#include "cellsweep/world/scene.h"
#include "engines/cell/sanitized.h"
#include "report/verify.h"

namespace cellsweep {
namespace {

using testing::HasSubstr;

Aabb cube_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Overlaps every other such box on the axes y and z, with no value equal to another's.
Aabb box_on_x(float low, float high, float offset) {
  return {{low, offset, offset}, {high, offset + 10, offset + 10}};
}

std::unique_ptr<Broadphase> paper(const EngineOptions& options = {}) {
  return std::move(*make_engine("cell-paper", options));
}

std::vector<Pair> pairs_after_update(Broadphase& engine) {
  EXPECT_TRUE(engine.update().ok());
  return {engine.pairs().begin(), engine.pairs().end()};
}

TEST(CellPaper, TakesMethods1And2Only) {
  for (const unsigned method : {0U, 3U, 77U}) {
    const auto made = make_engine("cell-paper", {.method = method});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.status().code, StatusCode::bad_option);
    EXPECT_EQ(made.status().setting, "method");
  }
}

TEST(CellPaper, RefusesALocalStoreThatCodeAndStackDoNotFitInto) {
  for (const std::uint64_t bytes : {std::uint64_t{1}, std::uint64_t{4096}, std::uint64_t{256 * 1024 + 1}}) {
    const auto made = make_engine("cell-paper", {.local_store_bytes = bytes});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.status().code, StatusCode::bad_option);
    EXPECT_EQ(made.status().setting, "local_store_bytes");
  }
}

TEST(CellPaper, RefusesATraceFileThatCannotBeWritten) {
  EngineOptions options;
  options.trace_file = "/nonexistent/trace.json";
  const auto made = make_engine("cell-paper", options);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().setting, "trace_file");
}

TEST(CellPaper, WritesATimelineWhenTheLastEngineOfAFileGoes) {
  EngineOptions options;
  options.trace_file = testing::TempDir() + "/cell_paper_trace.json";
  {
    const auto first = paper(options);
    const auto second = paper(options);
    for (Broadphase* engine : {first.get(), second.get()}) {
      ASSERT_TRUE(engine->insert(1, cube_at(0)).ok());
      ASSERT_TRUE(engine->update().ok());
    }
  }
  std::stringstream text;
  text << std::ifstream(options.trace_file).rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("traceEvents"));
  std::remove(options.trace_file.c_str());
}

TEST(CellPaper, RefusesMoreThanTheLocalStoreHoldsWithTheMap) {
  const auto engine = paper({.local_store_bytes = 112 * 1024});
  const Capacity capacity = engine->capacity();
  EXPECT_EQ(capacity.setting, "local_store_bytes");
  std::vector<BodyId> ids(capacity.bodies + 1);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>(i);
  const std::vector<Aabb> boxes(ids.size());
  const Status status = engine->insert(ids, boxes);
  EXPECT_EQ(status.code, StatusCode::capacity);
  for (const char* part : {"code", "stack", "values", "keys", "too many", "114688"}) {
    EXPECT_THAT(status.message, HasSubstr(part));
  }
}

TEST(CellPaper, UsesNoMoreLocalStoreThanItsMapSays) {
  if (cell::kSanitized) GTEST_SKIP() << "a sanitizer's data count too";
  for (const unsigned method : {1U, 2U}) {
    for (const bool list_dma : {false, true}) {
      EngineOptions options;
      options.method = method;
      options.list_dma = list_dma;
      const auto engine = paper(options);
      for (BodyId id = 0; id < 333; ++id)
        ASSERT_TRUE(engine->insert(id, cube_at(static_cast<float>(id))).ok());
      ASSERT_TRUE(engine->update().ok());
      std::uint64_t high_water = 0;
      for (const Counter& counter : engine->statistics().counters) {
        if (counter.name == "local store high water") high_water = counter.value;
      }
      const auto map = local_store_map("cell-paper", options, 333);
      ASSERT_TRUE(map.ok());
      EXPECT_GT(high_water, 0U);
      EXPECT_LE(high_water, map->used());
    }
  }
}

TEST(CellPaper, HasNoMapForAnEngineWithoutALocalStore) {
  EXPECT_EQ(local_store_map("control", {}, 10).status().code, StatusCode::bad_option);
  EXPECT_EQ(local_store_map("nobody", {}, 10).status().code, StatusCode::bad_option);
}

TEST(CellPaper, LiteralLosesABoxInsideAnotherWhenItPassesAThird) {
  for (const bool literal : {false, true}) {
    const auto engine = paper({.literal = literal});
    ASSERT_TRUE(engine->insert(1, box_on_x(-9, 9, 0)).ok());
    ASSERT_TRUE(engine->insert(2, box_on_x(0, 1, 1)).ok());
    ASSERT_TRUE(engine->insert(3, box_on_x(2, 3, 2)).ok());
    EXPECT_THAT(pairs_after_update(*engine), testing::SizeIs(2));
    // Bodies 2 and 3 change, body 1 does not: their earlier overlaps with it are cleared, and the walks
    // between their own ends do not meet it.
    ASSERT_TRUE(engine->move(2, box_on_x(4, 5, 1)).ok());
    EXPECT_THAT(pairs_after_update(*engine), testing::SizeIs(literal ? 0 : 2));
  }
}

TEST(CellPaper, LiteralMissesATouchThatBegins) {
  for (const bool literal : {false, true}) {
    const auto engine = paper({.literal = literal});
    ASSERT_TRUE(engine->insert(1, cube_at(5)).ok());
    ASSERT_TRUE(engine->insert(2, cube_at(0)).ok());
    ASSERT_TRUE(engine->update().ok());
    ASSERT_TRUE(engine->move(2, cube_at(4)).ok());
    EXPECT_EQ(pairs_after_update(*engine).size(), literal ? 0U : 1U);
  }
}

TEST(CellPaper, LiteralCountsWhatItMissedAgainstTheOracle) {
  const auto source =
      std::move(*make_scene_frames(SceneSettings{.scene = "varied", .bodies = 100, .moving = 0.5}));
  std::vector<std::unique_ptr<Broadphase>> engines;
  engines.push_back(paper({.literal = true}));
  engines.push_back(paper());
  const auto verdicts = report::verify_engines(engines, *source, 20);
  ASSERT_TRUE(verdicts.ok());
  EXPECT_GT(verdicts->front().missed, 0U);
  EXPECT_TRUE(verdicts->back().exact());
}

}  // namespace
}  // namespace cellsweep
