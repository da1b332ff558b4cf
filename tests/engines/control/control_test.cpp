/// @file
/// Engine `control` as a whole: its map of all possible pairs, what it counts, and what it misses literally.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "cellsweep/broadphase.h"
#include "cellsweep/world/scene.h"
#include "engines/control/pair_manager.h"
#include "engines/oracle/brute_force.h"
#include "frames.h"

namespace cellsweep {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Broadphase control_with(const ControlOptions& options) {
  return std::move(*make_broadphase(options));
}

std::uint64_t counter(const Broadphase& engine, std::string_view name) {
  for (const Counter& entry : engine.statistics().counters) {
    if (entry.name == name) return entry.value;
  }
  ADD_FAILURE() << "no counter " << name;
  return 0;
}

TEST(Control, HoldsFourThousandAndNinetySixBodiesByDefault) {
  EXPECT_EQ(control_with({}).capacity().bodies, 4096U);
}

TEST(Control, RefusesMoreBodiesThanItsPairMapMayHoldAndNamesTheSetting) {
  Broadphase engine = control_with({.pair_map_bytes = 3 * control::kPairMapEntryBytes});
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  for (BodyId id = 0; id < 3; ++id) ASSERT_TRUE(engine.insert(id, box).ok());
  const Status status = engine.insert(3, box);
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.number, 4U);
  EXPECT_EQ(status.limit, 3U);
  EXPECT_EQ(status.setting, "pair_map_bytes");
  EXPECT_THAT(status.message, HasSubstr("192 bytes"));
  EXPECT_EQ(engine.size(), 3U);
}

TEST(Control, RefusesAPairMapThatHoldsNoPair) {
  const Status status = make_broadphase(ControlOptions{.pair_map_bytes = 63}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "pair_map_bytes");
}

TEST(Control, FillsItsMapWithEveryPossiblePairAndMarksThatAsSetUp) {
  Broadphase engine = control_with({});
  for (BodyId id = 0; id < 20; ++id) {
    const auto x = static_cast<float>(3 * id);
    ASSERT_TRUE(engine.insert(id, {{x, 0, 0}, {x + 1, 1, 1}}).ok());
  }
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "pair map entries"), 190U);
  EXPECT_TRUE(engine.statistics().phases.front().kind == PhaseKind::setup);
  ASSERT_TRUE(engine.remove(4).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "pair map entries"), 171U);
}

TEST(Control, SwapsNothingInAFrameWhereNothingMoved) {
  auto source = std::move(*make_scene_frames({.scene = "varied", .bodies = 200, .moving = 0.0}));
  Broadphase engine = control_with({});
  ASSERT_TRUE(insert_all(engine, *source).ok());
  ASSERT_TRUE(engine.update().ok());
  const std::uint64_t swaps = counter(engine, "swaps");
  EXPECT_GT(swaps, 0U);
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok());
  EXPECT_EQ(counter(engine, "swaps"), swaps);
  EXPECT_TRUE(changes->began.empty());
  EXPECT_TRUE(changes->ended.empty());
}

TEST(Control, EndsThePairsOfARemovedBody) {
  Broadphase engine = control_with({});
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  ASSERT_TRUE(engine.insert(10, box).ok());
  ASSERT_TRUE(engine.insert(20, box).ok());
  ASSERT_TRUE(engine.update().ok());
  ASSERT_TRUE(engine.remove(10).ok());
  const auto changes = engine.update();
  ASSERT_TRUE(changes.ok());
  EXPECT_THAT(changes->ended, ElementsAre(Pair{10, 20}));
}

/// How many of the pairs that all against all finds are missed, summed over a scene's frames.
std::size_t missed_pairs(Broadphase engine) {
  const auto source = std::move(*make_scene_frames({.scene = "varied", .bodies = 400, .moving = 1.0}));
  EXPECT_TRUE(insert_all(engine, *source).ok());
  std::size_t missed = 0;
  for (int frame = 0; frame <= 30; ++frame) {
    EXPECT_TRUE(engine.update().ok());
    std::vector<Pair> only_truth;
    std::ranges::set_difference(brute_force_pairs(source->boxes()), engine.pairs(),
                                std::back_inserter(only_truth));
    missed += only_truth.size();
    source->advance();
    EXPECT_TRUE(move_changed(engine, *source).ok());
  }
  return missed;
}

TEST(Control, LiteralMissesPairsThatTheMendedOneFinds) {
  EXPECT_EQ(missed_pairs(control_with({})), 0U);
  EXPECT_GT(missed_pairs(control_with({.literal = true})), 0U);
}

TEST(Control, GivesTheKnownPairsOfTheRecordedPile) {
  Broadphase engine = control_with({});
  expect_recorded_frames(
      engine, "pile",
      {{0, 5577, 0x875cb2208a071dd3}, {15, 4914, 0xadd61a14b776a039}, {30, 3901, 0xc05c583740ead6b9}});
}

}  // namespace
}  // namespace cellsweep
