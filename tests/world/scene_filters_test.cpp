/// @file
/// The filters of a scene's bodies: what never moves may be static, and bodies may be in groups.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <utility>

#include "cellsweep/world/scene.h"

namespace cellsweep {
namespace {

std::unique_ptr<FrameSource> filtered_frames(const SceneSettings& settings) {
  auto frames = make_scene_frames(settings);
  EXPECT_TRUE(frames.ok()) << frames.status().message;
  return std::move(*frames);
}

TEST(SceneFilters, AreNoneUnlessAskedFor) {
  for (const SceneInfo& info : scene_table()) {
    EXPECT_TRUE(filtered_frames({.scene = std::string(info.name), .bodies = 60})->filters().empty());
  }
}

TEST(SceneFilters, CallStaticWhatNeverMoves) {
  for (const SceneInfo& info : scene_table()) {
    const auto frames =
        filtered_frames({.scene = std::string(info.name), .bodies = 200, .rest_is_static = true});
    ASSERT_EQ(frames->filters().size(), 200U);
    for (int frame = 0; frame < 20; ++frame) {
      ASSERT_TRUE(frames->advance());
      for (const BodyId id : frames->moved()) ASSERT_FALSE(frames->filters()[id].is_static) << info.name;
    }
  }
}

TEST(SceneFilters, FindAllThatStandsInAWorld) {
  const auto frames =
      filtered_frames({.scene = "uniform", .bodies = 200, .moving = 0.25, .rest_is_static = true});
  const auto is_static = [](const BodyFilter& filter) { return filter.is_static; };
  EXPECT_EQ(std::ranges::count_if(frames->filters(), is_static), 150);
  const auto pile = filtered_frames({.scene = "pile", .bodies = 200, .rest_is_static = true});
  EXPECT_EQ(std::ranges::count_if(pile->filters(), is_static), 1) << "the plane";
}

TEST(SceneFilters, PutBodiesIntoGroupsThatMeetTheOthers) {
  for (const unsigned groups : {2U, 3U, 32U}) {
    const auto frames = filtered_frames({.bodies = 100, .groups = groups});
    for (BodyId one = 0; one < 100; ++one) {
      for (BodyId other = 0; other < 100; ++other) {
        ASSERT_EQ(may_pair(frames->filters()[one], frames->filters()[other]), one % groups != other % groups);
      }
    }
  }
}

TEST(SceneFilters, AreRefusedBeyondTheBitsOfAMask) {
  const auto frames = make_scene_frames({.groups = 33});
  ASSERT_FALSE(frames.ok());
  EXPECT_THAT(frames.status().message, testing::HasSubstr("groups is 33; a mask has bits for 32 groups"));
}

}  // namespace
}  // namespace cellsweep
