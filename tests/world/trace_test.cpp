/// @file
/// Traces in memory: what a source told comes back, frame by frame.
#include "cellsweep/world/trace.h"

#include <gmock/gmock.h>

#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/scene.h"
#include "project_file.h"
#include "world/recording_matchers.h"
#include "world/same_frames.h"
#include "world/trace_check.h"
#include "world/traces.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Trace, OfNothingHasNoFramesAndNoIds) {
  const auto frames = make_trace_frames(std::make_shared<const Trace>());
  EXPECT_EQ(Trace().frames(), 0U);
  EXPECT_EQ(Trace().ids(), 0U);
  EXPECT_THAT(frames->boxes(), IsEmpty());
  EXPECT_THAT(frames->bodies(), IsEmpty());
  EXPECT_THAT(frames->moved(), IsEmpty());
  EXPECT_THAT(frames->removed(), IsEmpty());
  EXPECT_FALSE(frames->bodies_come_and_go());
  EXPECT_FALSE(frames->advance());
}

TEST(TraceFrames, TellWhoCameWentAndMoved) {
  const auto frames = make_trace_frames(std::make_shared<const Trace>(three_bodies_and_two_more()));
  EXPECT_EQ(frames->name(), "five");
  EXPECT_TRUE(frames->bodies_come_and_go());
  EXPECT_THAT(frames->bodies(), ElementsAre(0, 1, 2));
  EXPECT_THAT(frames->inserted(), IsEmpty()) << "those of frame 0 are there";
  EXPECT_THAT(frames->removed(), IsEmpty());
  EXPECT_THAT(frames->moved(), IsEmpty());
  ASSERT_TRUE(frames->advance());
  EXPECT_THAT(frames->bodies(), ElementsAre(1, 2, 5));
  EXPECT_THAT(frames->inserted(), ElementsAre(5));
  EXPECT_THAT(frames->removed(), ElementsAre(0));
  EXPECT_THAT(frames->moved(), ElementsAre(1));
  EXPECT_EQ(frames->boxes()[1], cube(4));
  EXPECT_EQ(frames->boxes()[2], cube(6)) << "who is not mentioned stays";
  ASSERT_TRUE(frames->advance());
  EXPECT_THAT(frames->bodies(), ElementsAre(0, 1, 5));
  EXPECT_THAT(frames->inserted(), ElementsAre(0));
  EXPECT_EQ(frames->boxes()[0], cube(20));
  EXPECT_EQ(frames->boxes()[5], cube(9));
  EXPECT_FALSE(frames->advance());
  EXPECT_THAT(frames->bodies(), ElementsAre(0, 1, 5)) << "after the last frame nothing changes";
}

TEST(TraceFrames, GiveEachBodyTheFilterThatItCameWith) {
  const auto frames = make_trace_frames(std::make_shared<const Trace>(three_bodies_and_two_more()));
  EXPECT_TRUE(frames->filters()[0].is_static);
  EXPECT_EQ(frames->filters()[2].category, 4U);
  ASSERT_TRUE(frames->advance() && frames->advance());
  EXPECT_FALSE(frames->filters()[0].is_static) << "another body of the same id";
}

TEST(TraceFrames, OfTheSameBodiesInAllFramesDoNotComeAndGo) {
  const auto source = std::move(*make_scene_frames({.scene = "uniform", .bodies = 10}));
  const auto frames = make_trace_frames(std::make_shared<const Trace>(record_trace(*source, 3)));
  EXPECT_FALSE(frames->bodies_come_and_go());
  EXPECT_THAT(frames->filters(), IsEmpty());
}

TEST(RecordTrace, OfEverySceneHoldsTogetherAndTellsTheSame) {
  for (const SceneInfo& scene : scene_table()) {
    SceneSettings settings{.scene = std::string(scene.name), .bodies = 150};
    settings.rest_is_static = true;
    settings.groups = 3;
    const auto trace = std::make_shared<const Trace>(record_trace(**make_scene_frames(settings), 19));
    EXPECT_EQ(trace->frames(), 20U) << scene.name;
    const auto fault = find_fault(*trace);
    ASSERT_FALSE(fault) << scene.name << ": " << fault->list << " " << fault->expected << " " << fault->found;
    expect_same_frames(**make_scene_frames(settings), *make_trace_frames(trace), 20);
  }
}

TEST(FrameFile, GivesFramesOfRecordingsAndTraces) {
  const FrameFile trace(three_bodies_and_two_more());
  EXPECT_EQ(trace.ids(), 6U);
  EXPECT_EQ(trace.frames(), 3U);
  EXPECT_THAT(trace.make_source()->bodies(), ElementsAre(0, 1, 2));
  const FrameFile recording(Recording{"two", "", {}, 2, {cube(0), cube(1), cube(0), cube(2)}});
  EXPECT_EQ(recording.ids(), 2U);
  EXPECT_EQ(recording.frames(), 2U);
  EXPECT_THAT(recording.make_source()->boxes(), ElementsAre(cube(0), cube(1)));
  EXPECT_THAT(read_frame_file("none.aabbs"), RefusedWith(testing::HasSubstr("none.aabbs")));
  EXPECT_THAT(read_frame_file("none.npz"), RefusedWith(testing::HasSubstr("none.npz")));
}

TEST(FrameFile, HasTheTraceOfABulletWorldWhoseBodiesComeGoAndFallAsleep) {
  if (!traces_have_files()) GTEST_SKIP() << "a build without libzip";
  const Result<FrameFile> file = read_frame_file(project_file("bench/scenes/bullet-falling-40.npz"));
  ASSERT_TRUE(file.ok()) << file.status().message;
  EXPECT_EQ(file->frames(), 300U);
  const auto frames = file->make_source();
  EXPECT_EQ(frames->name(), "bullet-falling-40");
  EXPECT_TRUE(frames->bodies_come_and_go());
  EXPECT_EQ(frames->bodies().size(), 42U) << "a plane, the cubes, and the first spark";
  while (frames->advance()) {
  }
  EXPECT_EQ(frames->bodies().size(), 41U);
  EXPECT_THAT(frames->moved(), IsEmpty()) << "all are asleep";
}

}  // namespace
}  // namespace cellsweep
