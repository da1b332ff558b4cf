/// @file
/// What a recording and a trace say alike.
#include "cellsweep/world/frame_file.h"

#include <gtest/gtest.h>

#include <vector>

#include "traces.h"

namespace cellsweep {
namespace {

std::vector<Aabb> all_boxes(const FrameFile& file) {
  std::vector<Aabb> all;
  EXPECT_TRUE(file.for_each_box([&](const Aabb& box) { all.push_back(box); }).ok());
  return all;
}

TEST(FrameFile, OfARecordingIsInTheWorldThatTheRecordingNames) {
  const Aabb room{{-9, -9, -9}, {30, 30, 30}};
  const FrameFile file(Recording{"two", "boxes", room, 1, {cube(0), cube(3)}});
  EXPECT_EQ(file.world(), room);
  EXPECT_EQ(all_boxes(file), (std::vector{cube(0), cube(3)}));
  EXPECT_EQ(file.frames(), 2U);
  EXPECT_EQ(file.ids(), 1U);
}

TEST(FrameFile, OfATraceIsInTheWorldAroundAllThatCameOrMoved) {
  const FrameFile file(three_bodies_and_two_more());
  EXPECT_EQ(file.world(), (Aabb{{0, 0, 0}, {21, 21, 21}}));
  EXPECT_EQ(all_boxes(file).size(), 7U);
  EXPECT_EQ(file.frames(), 3U);
  EXPECT_EQ(file.ids(), 6U);
}

TEST(FrameFile, OfATraceOfNobodyIsAtTheOrigin) {
  Trace nobody;
  nobody.inserted_ends = nobody.removed_ends = nobody.moved_ends = {0};
  const FrameFile file(nobody);
  EXPECT_EQ(file.world(), Aabb{});
  EXPECT_TRUE(all_boxes(file).empty());
}

TEST(FrameFile, MakesSourcesThatStandAtTheFirstFrame) {
  const FrameFile file(three_bodies_and_two_more());
  const auto first = file.make_source();
  ASSERT_TRUE(first->advance());
  const auto second = file.make_source();
  EXPECT_EQ(second->bodies().size(), 3U);
  EXPECT_EQ(second->boxes()[0], cube(0));
}

}  // namespace
}  // namespace cellsweep
