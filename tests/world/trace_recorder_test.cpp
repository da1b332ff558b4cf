/// @file
/// Traces of what a program told: short ones by hand, long ones against what was there.
#include "cellsweep/world/trace_recorder.h"

#include <gmock/gmock.h>

#include <map>

#include "contract/random.h"
#include "world/recording_matchers.h"
#include "world/trace_check.h"
#include "world/traces.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(TraceRecorder, NotesWhoComesMovesAndGoes) {
  TraceRecorder recorder;
  ASSERT_TRUE(recorder.insert(700, cube(0)).ok());
  ASSERT_TRUE(recorder.insert(4'000'000'000, cube(3), {2, 3, true}).ok());
  recorder.end_frame();
  ASSERT_TRUE(recorder.move(700, cube(1)).ok());
  ASSERT_TRUE(recorder.move(700, cube(2)).ok());
  ASSERT_TRUE(recorder.remove(4'000'000'000).ok());
  recorder.end_frame();
  ASSERT_TRUE(recorder.insert(8, cube(9)).ok());
  recorder.end_frame();
  const Trace& trace = recorder.trace();
  EXPECT_THAT(trace.inserted, ElementsAre(0, 1, 1)) << "the lowest number that is free";
  EXPECT_THAT(trace.inserted_ends, ElementsAre(2, 2, 3));
  EXPECT_EQ(trace.inserted_filters[1], (BodyFilter{2, 3, true}));
  EXPECT_THAT(trace.moved, ElementsAre(0));
  EXPECT_THAT(trace.moved_boxes, ElementsAre(cube(2))) << "the last box counts";
  EXPECT_THAT(trace.removed_ends, ElementsAre(0, 1, 1));
  EXPECT_FALSE(find_fault(trace));
}

TEST(TraceRecorder, LeavesOutWhatCameToNothing) {
  TraceRecorder recorder;
  ASSERT_TRUE(recorder.insert(1, cube(0)).ok());
  recorder.end_frame();
  ASSERT_TRUE(recorder.move(1, cube(5)).ok());
  ASSERT_TRUE(recorder.move(1, cube(0)).ok());
  ASSERT_TRUE(recorder.insert(2, cube(0)).ok());
  ASSERT_TRUE(recorder.remove(2).ok());
  recorder.end_frame();
  EXPECT_THAT(recorder.trace().moved, IsEmpty());
  EXPECT_THAT(recorder.trace().inserted, ElementsAre(0));
  EXPECT_THAT(recorder.trace().removed, IsEmpty());
}

TEST(TraceRecorder, MakesAnotherBodyOfOneWhoseIdOrFilterIsNew) {
  TraceRecorder recorder;
  ASSERT_TRUE(recorder.insert(1, cube(0)).ok());
  ASSERT_TRUE(recorder.set_filter(1, {2, 2, false}).ok());
  recorder.end_frame();
  ASSERT_TRUE(recorder.remove(1).ok());
  ASSERT_TRUE(recorder.insert(1, cube(7)).ok());
  recorder.end_frame();
  ASSERT_TRUE(recorder.move(1, cube(8)).ok());
  ASSERT_TRUE(recorder.set_filter(1, {4, 4, false}).ok());
  ASSERT_TRUE(recorder.set_filter(1, {4, 4, false}).ok());
  recorder.end_frame();
  const Trace& trace = recorder.trace();
  EXPECT_THAT(trace.inserted, ElementsAre(0, 1, 0));
  EXPECT_THAT(trace.removed, ElementsAre(0, 1));
  EXPECT_EQ(trace.inserted_boxes.back(), cube(8));
  EXPECT_EQ(trace.inserted_filters.front().mask, 2U);
  EXPECT_FALSE(find_fault(trace));
}

TEST(TraceRecorder, RefusesBodiesThatAreThereOrNot) {
  TraceRecorder recorder;
  ASSERT_TRUE(recorder.insert(1, cube(0)).ok());
  EXPECT_THAT(recorder.insert(1, cube(2)).message, HasSubstr("body 1 is there already"));
  EXPECT_THAT(recorder.move(2, cube(2)).message, HasSubstr("body 2 is not there"));
  EXPECT_FALSE(recorder.remove(2).ok());
  EXPECT_FALSE(recorder.set_filter(2, {}).ok());
  recorder.end_frame();
  EXPECT_THAT(recorder.trace().inserted_boxes, ElementsAre(cube(0)));
}

/// The boxes of all that are there, in order.
std::vector<float> places_in(const FrameSource& frames) {
  std::vector<float> places;
  for (const BodyId body : frames.bodies()) places.push_back(frames.boxes()[body].min[0]);
  std::ranges::sort(places);
  return places;
}

TEST(TraceRecorder, OfAnyCallsHasWhatWasThereInEveryFrame) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    contract::Random random(seed);
    TraceRecorder recorder;
    std::map<BodyId, float> truth;
    std::vector<std::vector<float>> expected;
    for (int frame = 0; frame < 40; ++frame) {
      for (std::uint64_t call = random.below(12); call > 0; --call) {
        const auto id = static_cast<BodyId>(random.below(15) * 99'999'999);
        const auto place = static_cast<float>(random.below(50));
        const bool held = truth.contains(id);
        switch (random.below(4)) {
          case 0:
            ASSERT_EQ(recorder.insert(id, cube(place)).ok(), !held);
            if (!held) truth[id] = place;
            break;
          case 1:
            ASSERT_EQ(recorder.remove(id).ok(), held);
            truth.erase(id);
            break;
          case 2:
            ASSERT_EQ(recorder.set_filter(id, {1, static_cast<std::uint32_t>(random.below(3)), false}).ok(),
                      held);
            break;
          default:
            ASSERT_EQ(recorder.move(id, cube(place)).ok(), held);
            if (held) truth[id] = place;
        }
      }
      recorder.end_frame();
      expected.emplace_back();
      for (const auto& [id, place] : truth) expected.back().push_back(place);
      std::ranges::sort(expected.back());
    }
    ASSERT_FALSE(find_fault(recorder.trace()));
    const auto frames = make_trace_frames(std::make_shared<const Trace>(recorder.trace()));
    for (const std::vector<float>& places : expected) {
      ASSERT_EQ(places_in(*frames), places);
      frames->advance();
    }
  }
}

}  // namespace
}  // namespace cellsweep
