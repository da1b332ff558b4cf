#include "engines/control/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cellsweep/engines.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/scene.h"
#include "report/run_engine.h"
#include "report/verify.h"

namespace cellsweep {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::unique_ptr<Broadphase> control_with(const EngineOptions& options) {
  return std::move(*make_engine("control", options));
}

std::uint64_t counter(const Broadphase& engine, std::string_view name) {
  for (const Counter& entry : engine.statistics().counters) {
    if (entry.name == name) return entry.value;
  }
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

TEST(Control, HoldsFourThousandAndNinetySixBodiesByDefault) {
  EXPECT_EQ(control_with({})->capacity().bodies, 4096U);
}

TEST(Control, RefusesMoreBodiesThanItsPairMapMayHoldAndNamesTheSetting) {
  auto engine = control_with({.pair_map_bytes = 3 * control::kPairMapEntryBytes});
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  for (BodyId id = 0; id < 3; ++id) ASSERT_TRUE(engine->insert(id, box).ok());
  const Status status = engine->insert(3, box);
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.number, 4U);
  EXPECT_EQ(status.limit, 3U);
  EXPECT_EQ(status.setting, "pair_map_bytes");
  EXPECT_THAT(status.message, HasSubstr("192 bytes"));
  EXPECT_EQ(engine->size(), 3U);
}

TEST(Control, RefusesAPairMapThatHoldsNoPair) {
  EXPECT_EQ(make_engine("control", {.pair_map_bytes = 63}).status().code, StatusCode::bad_option);
}

TEST(Control, FillsItsMapWithEveryPossiblePairAndMarksThatAsSetUp) {
  auto engine = control_with({});
  for (BodyId id = 0; id < 20; ++id) {
    const auto x = static_cast<float>(3 * id);
    ASSERT_TRUE(engine->insert(id, {{x, 0, 0}, {x + 1, 1, 1}}).ok());
  }
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "pair map entries"), 190U);
  EXPECT_TRUE(engine->statistics().phases.front().setup);
  ASSERT_TRUE(engine->remove(4).ok());
  ASSERT_TRUE(engine->update().ok());
  EXPECT_EQ(counter(*engine, "pair map entries"), 171U);
}

TEST(Control, SwapsNothingInAFrameWhereNothingMoved) {
  auto source = std::move(*make_scene_frames({.scene = "varied", .bodies = 200, .moving = 0.0}));
  auto engine = control_with({});
  ASSERT_TRUE(report::insert_all(*engine, *source).ok());
  ASSERT_TRUE(engine->update().ok());
  const std::uint64_t swaps = counter(*engine, "swaps");
  EXPECT_GT(swaps, 0U);
  const auto changes = engine->update();
  ASSERT_TRUE(changes.ok());
  EXPECT_EQ(counter(*engine, "swaps"), swaps);
  EXPECT_TRUE(changes->began.empty());
  EXPECT_TRUE(changes->ended.empty());
}

TEST(Control, EndsThePairsOfARemovedBody) {
  auto engine = control_with({});
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  ASSERT_TRUE(engine->insert(10, box).ok());
  ASSERT_TRUE(engine->insert(20, box).ok());
  ASSERT_TRUE(engine->update().ok());
  ASSERT_TRUE(engine->remove(10).ok());
  const auto changes = engine->update();
  ASSERT_TRUE(changes.ok());
  EXPECT_THAT(changes->ended, ElementsAre(Pair{10, 20}));
}

TEST(Control, LiteralMissesPairsThatTheMendedOneFinds) {
  const auto verdict_of = [](bool literal) {
    std::vector<std::unique_ptr<Broadphase>> engines;
    engines.push_back(control_with({.literal = literal}));
    auto source = std::move(*make_scene_frames({.scene = "varied", .bodies = 400, .moving = 1.0}));
    return std::move(report::verify_engines(engines, *source, 30)->front());
  };
  EXPECT_TRUE(verdict_of(false).exact());
  EXPECT_GT(verdict_of(true).missed, 0U);
}

TEST(Control, GivesTheKnownPairsOfTheRecordedPile) {
  auto recording = read_recording(CELLSWEEP_SOURCE_DIR "/bench/scenes/bullet-pile-1024.aabbs");
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  auto source = make_recording_frames(std::move(*recording));
  auto engine = control_with({});
  const auto run = report::run_engine(*engine, *source, {30, {0, 15, 30}});
  ASSERT_TRUE(run.ok()) << run.status().message;
  EXPECT_EQ(run->frames[0].pairs, 5577U);
  EXPECT_EQ(hash_text(run->frames[0].hash), "875cb2208a071dd3");
}

}  // namespace
}  // namespace cellsweep
