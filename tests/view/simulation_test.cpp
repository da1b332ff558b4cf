#include "view/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "report/all_engines.h"
#include "report/oracle.h"
#include "view/drawn_boxes.h"

namespace cellsweep::view {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

// control's map of all possible pairs holds 4,096.
constexpr std::size_t kMoreThanControlHolds = 5000;

SimulationSettings scene(std::size_t bodies, double moving = 0.5) {
  return {.recording = std::nullopt,
          .scene = {.scene = "paper", .bodies = bodies, .moving = moving},
          .engine = "stream",
          .settings = {}};
}

std::unique_ptr<Simulation> made(SimulationSettings settings) {
  auto simulation = Simulation::make(std::move(settings));
  EXPECT_TRUE(simulation.ok()) << simulation.status().message;
  return std::move(*simulation);
}

void step(Simulation& simulation, int frames) {
  for (int frame = 0; frame < frames; ++frame) ASSERT_TRUE(simulation.step().ok());
}

std::vector<Aabb> boxes_of(const FrameSource& source) {
  return {source.boxes().begin(), source.boxes().end()};
}

std::size_t right_pairs(const Simulation& simulation) {
  return report::oracle_pairs(simulation.source().boxes()).size();
}

/// Two boxes that meet in the second of three frames.
FrameFile meeting() {
  const Aabb still{{0, 0, 0}, {1, 1, 1}};
  const Aabb apart{{4, 0, 0}, {5, 1, 1}};
  const Aabb near{{1, 0, 0}, {2, 1, 1}};
  return FrameFile(Recording{
      "meeting", "boxes", Aabb{{0, 0, 0}, {6, 6, 6}}, 2, {still, apart, still, near, still, apart}});
}

/// Pairs of which one body moves at least.
std::size_t pairs_with_movers(const Simulation& simulation) {
  const auto filters = simulation.source().filters();
  std::size_t count = 0;
  for (const Pair& pair : report::oracle_pairs(simulation.source().boxes()))
    count += filters[pair.a].is_static && filters[pair.b].is_static ? 0 : 1;
  return count;
}

std::vector<DrawnBox> drawn_without_a_tool(const Simulation& simulation) {
  return drawn_boxes(simulation, Probe(simulation.bounds()), {}).all;
}

TEST(Simulation, HasNoPairsOfTwoStaticBodiesWhoeverTheseAre) {
  SimulationSettings settings = scene(400, 0.3);
  settings.scene.rest_is_static = true;
  const auto simulation = made(settings);
  EXPECT_LT(pairs_with_movers(*simulation), right_pairs(*simulation));
  for (const double moving : {0.3, 0.1, 0.8, 0.0, 1.0}) {
    ASSERT_TRUE(simulation->use_moving(moving).ok());
    step(*simulation, 3);
    ASSERT_THAT(simulation->engine().pairs(), SizeIs(pairs_with_movers(*simulation))) << moving << " move";
    EXPECT_EQ(simulation->source().boxes().size(), 400U);
  }
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_THAT(simulation->engine().pairs(), SizeIs(pairs_with_movers(*simulation)));
}

TEST(Simulation, HasNoPairsWithinAGroup) {
  SimulationSettings settings = scene(400);
  settings.scene.groups = 2;
  const auto simulation = made(settings);
  step(*simulation, 5);
  EXPECT_FALSE(simulation->engine().pairs().empty());
  for (const Pair& pair : simulation->engine().pairs()) EXPECT_NE(pair.a % 2, pair.b % 2);
}

TEST(Simulation, ShowsAScriptWhoseBodiesComeAndGo) {
  SimulationSettings settings = scene(0);
  settings.scene = {.scene = "open-world", .bodies = 600};
  const auto simulation = made(settings);
  const auto frames = std::move(*make_scene_frames(settings.scene));
  for (int frame = 0; frame < 20; ++frame) {
    step(*simulation, 1);
    ASSERT_TRUE(frames->advance());
    EXPECT_EQ(boxes_of(simulation->source()), boxes_of(*frames));
    EXPECT_EQ(simulation->engine().pairs().size(), report::oracle_pairs(*frames).size());
  }
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_EQ(simulation->engine().pairs().size(), report::oracle_pairs(*frames).size());
  EXPECT_THAT(drawn_without_a_tool(*simulation), SizeIs(frames->bodies().size() + 12));
}

TEST(Simulation, BeginsAScriptAnewWhenAnotherShareOfItMoves) {
  SimulationSettings settings = scene(0);
  settings.scene = {.scene = "ragdolls", .bodies = 240};
  const auto simulation = made(settings);
  EXPECT_EQ(simulation->moving(), 0.01);
  step(*simulation, 3);
  ASSERT_TRUE(simulation->use_moving(1).ok());
  EXPECT_EQ(simulation->frame(), 0U);
  step(*simulation, 1);
  EXPECT_EQ(simulation->source().moved().size(), 240U);
  EXPECT_EQ(simulation->use_moving(2).code, StatusCode::bad_option);
  EXPECT_EQ(simulation->moving(), 1);
}

TEST(Simulation, ShowsTheFramesOfTheScene) {
  const SimulationSettings settings = scene(50);
  const auto simulation = made(settings);
  const auto frames = make_scene_frames(settings.scene);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(boxes_of(simulation->source()), boxes_of(**frames));
    EXPECT_EQ(simulation->source().poses()[7], (*frames)->poses()[7]);
    step(*simulation, 1);
    (*frames)->advance();
  }
  EXPECT_EQ(simulation->frame(), 20U);
}

TEST(Simulation, PaintsGreenWhatAnyEngineFindsColliding) {
  const auto simulation = made(scene(150));
  for (const EngineInfo& info : engine_table()) {
    ASSERT_TRUE(simulation->use_engine(info.name).ok()) << info.name;
    step(*simulation, 3);
    std::vector<bool> expected(150, false);
    for (const Pair& pair : report::oracle_pairs(simulation->source().boxes()))
      expected[pair.a] = expected[pair.b] = true;
    EXPECT_EQ(simulation->colliding(), expected) << info.name;
    EXPECT_EQ(simulation->engine_name(), info.name);
    const std::vector<DrawnBox> drawn = drawn_without_a_tool(*simulation);
    ASSERT_THAT(drawn, SizeIs(150 + 12));
    for (std::size_t body = 0; body < expected.size(); ++body)
      EXPECT_EQ(drawn[body].color == WorldColors().colliding, expected[body]) << body;
  }
  EXPECT_EQ(simulation->frame(), 3 * engine_table().size());
}

TEST(Simulation, KeepsEngineBodiesAndFrameWhenAnEngineCannotHoldTheBodies) {
  const auto simulation = made(scene(kMoreThanControlHolds, 0.01));
  step(*simulation, 2);
  const std::vector<Aabb> before = boxes_of(simulation->source());
  const Status status = simulation->use_engine("control");
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_THAT(status.message, HasSubstr("5000"));
  EXPECT_EQ(simulation->engine_name(), "stream");
  EXPECT_EQ(boxes_of(simulation->source()), before);
  step(*simulation, 1);
  EXPECT_EQ(simulation->frame(), 3U);
  EXPECT_EQ(simulation->engine().name(), "stream");
}

TEST(Simulation, KeepsItsBodiesWhenTheEngineCannotHoldMore) {
  SimulationSettings settings = scene(40);
  settings.engine = "control";
  const auto simulation = made(settings);
  step(*simulation, 2);
  EXPECT_EQ(simulation->use_bodies(kMoreThanControlHolds).code, StatusCode::capacity);
  EXPECT_EQ(simulation->bodies(), 40U);
  EXPECT_EQ(simulation->frame(), 2U);
  EXPECT_EQ(simulation->use_bodies(0).code, StatusCode::bad_option);
  ASSERT_TRUE(simulation->use_bodies(80).ok());
  EXPECT_EQ(simulation->bodies(), 80U);
  EXPECT_EQ(simulation->frame(), 0U);
  EXPECT_EQ(simulation->engine().pairs().size(), right_pairs(*simulation));
}

TEST(Simulation, LeavesBodiesWhereTheyAreWhenAnotherShareMoves) {
  const auto simulation = made(scene(100, 0.3));
  step(*simulation, 10);
  const std::vector<Aabb> before = boxes_of(simulation->source());
  ASSERT_TRUE(simulation->use_moving(0.8).ok());
  EXPECT_EQ(boxes_of(simulation->source()), before);
  EXPECT_EQ(simulation->frame(), 10U);
  step(*simulation, 1);
  EXPECT_THAT(simulation->source().moved(), SizeIs(80));
  EXPECT_EQ(simulation->engine().pairs().size(), right_pairs(*simulation));
  ASSERT_TRUE(simulation->use_moving(0).ok());
  step(*simulation, 1);
  EXPECT_THAT(simulation->source().moved(), SizeIs(0));
  EXPECT_EQ(simulation->use_moving(1.5).code, StatusCode::bad_option);
  EXPECT_EQ(simulation->moving(), 0);
}

TEST(Simulation, LetsBodiesThatStillMoveKeepTheirCourse) {
  const auto changed = made(scene(100, 0.3));
  const auto unchanged = made(scene(100, 0.3));
  step(*changed, 100);  // some have turned back at a plane
  step(*unchanged, 100);
  ASSERT_TRUE(changed->use_moving(0.6).ok());
  step(*changed, 5);
  step(*unchanged, 5);
  ASSERT_THAT(unchanged->source().moved(), SizeIs(30));
  for (const BodyId id : unchanged->source().moved())
    EXPECT_EQ(changed->source().boxes()[id], unchanged->source().boxes()[id]) << id;
}

TEST(Simulation, BeginsARecordingAgainBehindItsLastFrame) {
  SimulationSettings settings = scene(1);
  settings.recording = meeting();
  const auto simulation = made(settings);
  std::vector<std::size_t> pairs;
  for (int frame = 0; frame < 7; ++frame) {
    pairs.push_back(simulation->engine().pairs().size());
    step(*simulation, 1);
  }
  EXPECT_THAT(pairs, testing::ElementsAre(0, 1, 0, 0, 1, 0, 0));
  EXPECT_EQ(simulation->source_name(), "meeting");
}

TEST(Simulation, LeavesARecordingsBodiesAlone) {
  SimulationSettings settings = scene(1);
  settings.recording = meeting();
  const auto simulation = made(settings);
  EXPECT_THAT(simulation->use_bodies(10).message, HasSubstr("recording"));
  EXPECT_THAT(simulation->use_moving(0.5).message, HasSubstr("recording"));
  EXPECT_EQ(simulation->bodies(), 2U);
}

TEST(Simulation, RemembersTheTimesOfTheLatestFramesOfOneEngine) {
  const auto simulation = made(scene(10));
  step(*simulation, static_cast<int>(Simulation::kRememberedFrames) + 5);
  EXPECT_THAT(simulation->frame_times(), SizeIs(Simulation::kRememberedFrames));
  ASSERT_TRUE(simulation->restart().ok());
  EXPECT_THAT(simulation->frame_times(), SizeIs(Simulation::kRememberedFrames));
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_THAT(simulation->frame_times(), SizeIs(0));
  step(*simulation, 1);
  ASSERT_TRUE(simulation->use_bodies(11).ok());
  EXPECT_THAT(simulation->frame_times(), SizeIs(0));
}

TEST(Simulation, KnowsWhatTheEngineTookForTheFrame) {
  const auto simulation = made(scene(100));
  EXPECT_GT(simulation->frame_time().total_ms, 0) << "frame 0";
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_GT(simulation->frame_time().setup_ms, 0) << "its map of all pairs";
  EXPECT_FALSE(simulation->frame_time().phases.empty());
  step(*simulation, 1);
  EXPECT_LT(simulation->frame_time().setup_ms, simulation->frame_time().total_ms);
  EXPECT_EQ(simulation->frame_times().back(), static_cast<float>(simulation->frame_time().work_ms()));
}

TEST(Simulation, GivesEachEngineTheSettingsThatItHas) {
  SimulationSettings settings = scene(10);
  settings.settings = {{"threads", "1"}, {"pair_map_bytes", std::to_string(64 * 45)}};  // ten bodies
  const auto simulation = made(settings);
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_EQ(simulation->use_bodies(11).code, StatusCode::capacity);
  ASSERT_TRUE(simulation->use_engine("stream").ok());
  EXPECT_TRUE(simulation->use_bodies(11).ok());
}

bool encloses(const Aabb& outer, const Aabb& inner) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (outer.min[axis] > inner.min[axis] || outer.max[axis] < inner.max[axis]) return false;
  }
  return true;
}

TEST(Simulation, ShowsAFatBoxAroundEachBodyOfStreamAndNoneOfOtherEngines) {
  SimulationSettings settings = scene(60);
  settings.settings = {
      {"margin", "0.01"}};  // without one a small world in motion has neither fat boxes nor cells
  const auto simulation = made(settings);
  step(*simulation, 5);
  const auto view = simulation->stream_view();
  ASSERT_TRUE(view.has_value());
  ASSERT_THAT(view->fat_boxes, SizeIs(60));
  EXPECT_FALSE(view->cells.empty());
  for (const Aabb& box : simulation->source().boxes()) {
    EXPECT_TRUE(std::any_of(view->fat_boxes.begin(), view->fat_boxes.end(),
                            [&](const Aabb& fat) { return encloses(fat, box); }));
  }
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_FALSE(simulation->stream_view().has_value());
}

TEST(LineBoxes, AreThosePartsOfStreamThatAreAskedForNearTheWorld) {
  const auto simulation = made(scene(60));
  const std::size_t fat = simulation->stream_view()->fat_boxes.size();
  const std::size_t cells = simulation->stream_view()->cells.size();
  EXPECT_THAT(line_boxes(*simulation, {}), SizeIs(0));
  EXPECT_THAT(line_boxes(*simulation, {.fat_boxes = true, .cells = false}), SizeIs(fat));
  const std::vector<LineBox> all = line_boxes(*simulation, {.fat_boxes = true, .cells = true});
  ASSERT_THAT(all, SizeIs(fat + cells));
  const Aabb& world = simulation->bounds();
  for (const LineBox& line : all) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float edge = world.max[axis] - world.min[axis];
      EXPECT_GE(line.min[axis], world.min[axis] - edge);
      EXPECT_LE(line.max[axis], world.max[axis] + edge);
    }
  }
  ASSERT_TRUE(simulation->use_engine("control").ok());
  EXPECT_THAT(line_boxes(*simulation, {.fat_boxes = true, .cells = true}), SizeIs(0));
}

TEST(Simulation, KnowsTheLocalStoreOfEnginesThatHaveOne) {
  const auto simulation = made(scene(100));
  for (const EngineInfo& info : engine_table()) {
    ASSERT_TRUE(simulation->use_engine(info.name).ok());
    ASSERT_EQ(simulation->local_store().has_value(), info.name.starts_with("cell-")) << info.name;
    if (!simulation->local_store()) continue;
    EXPECT_EQ(simulation->local_store()->bodies, 100U);
    EXPECT_EQ(simulation->local_store()->spus, 3U);
    EXPECT_GT(report::used_bytes(*simulation->local_store()), 0U);
  }
}

}  // namespace
}  // namespace cellsweep::view
