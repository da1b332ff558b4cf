#include "report/picture/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "cellsweep/world/scene.h"
#include "fake_frames.h"

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;

const Aabb kRoom{{0, 0, 0}, {10, 10, 10}};

BodyPose cube(float x, float y, float z, float half) {
  return {{x, y, z}, {half, half, half}};
}

PictureSettings small_picture(unsigned threads = 1) {
  return {.width = 96, .height = 64, .samples = 4, .threads = threads};
}

/// Mean of a channel (0 red, 1 green, 2 blue) over the middle of a picture.
double middle(const Image& image, unsigned channel) {
  double sum = 0;
  unsigned count = 0;
  for (unsigned row = image.height * 2 / 5; row < image.height * 3 / 5; ++row) {
    for (unsigned column = image.width * 2 / 5; column < image.width * 3 / 5; ++column, ++count) {
      sum += image.rgb[3 * (row * image.width + column) + channel];
    }
  }
  return sum / count;
}

Image traced(const Tableau& tableau, const PictureSettings& settings = small_picture()) {
  return std::move(*trace_picture(tableau, settings));
}

Image paper_scene(std::uint64_t seed, unsigned threads) {
  const SceneSettings scene{.bodies = 200, .seed = seed};
  const Aabb world = make_scene(scene)->bounds();
  return traced(tableau_of(**make_scene_frames(scene), world), small_picture(threads));
}

TEST(Picture, ShowsABoxGreyAndACollidingOneGreen) {
  const Image plain = traced({kRoom, {cube(5, 5, 5, 3)}, {false}});
  EXPECT_NEAR(middle(plain, 0), middle(plain, 1), 12);
  EXPECT_NEAR(middle(plain, 1), middle(plain, 2), 25);
  const Image green = traced({kRoom, {cube(5, 5, 5, 3)}, {true}});
  EXPECT_GT(middle(green, 1), 2 * middle(green, 0));
  EXPECT_GT(middle(green, 1), 2 * middle(green, 2));
}

TEST(Picture, HidesWhatStandsBehind) {
  const Image one = traced({kRoom, {cube(5, 5, 5, 3)}, {false}});
  const Image two = traced({kRoom, {cube(5, 5, 5, 3), cube(5, 5, 5, 2)}, {false, true}});
  EXPECT_EQ(one.rgb, two.rgb);
}

TEST(Picture, CastsAShadowOnWhatIsBelow) {
  Tableau tableau{kRoom, {cube(5, 5, 5, 3)}, {false}};
  const double in_the_sun = middle(traced(tableau), 1);
  tableau.bodies.push_back({{5, 9.6F, 5}, {7, 0.2F, 7}});
  tableau.colliding.push_back(false);
  EXPECT_LT(middle(traced(tableau), 1), in_the_sun - 15);
}

TEST(Picture, TurnsBodiesAsTheirPosesSay) {
  Tableau straight{kRoom, {{{5, 5, 5}, {4, 0.5F, 0.5F}}}, {false}};
  Tableau turned = straight;
  turned.bodies[0].orientation = {0, 0, 0.70710678F, 0.70710678F};
  EXPECT_NE(traced(straight).rgb, traced(turned).rgb);
  Tableau upright{kRoom, {{{5, 5, 5}, {0.5F, 4, 0.5F}}}, {false}};
  const Image one = traced(turned);
  const Image other = traced(upright);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < one.rgb.size(); ++i)
    differing += std::abs(one.rgb[i] - other.rgb[i]) > 8 ? 1 : 0;
  EXPECT_LT(differing, one.rgb.size() / 100) << "a quarter turn makes the lying bar a standing one";
}

TEST(Picture, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const Image one = paper_scene(1, 1);
  EXPECT_EQ(one.rgb, paper_scene(1, 3).rgb);
  EXPECT_NE(one.rgb, paper_scene(2, 1).rgb);
}

TEST(Picture, HasTheKnownPixelsForASeed) {
  std::uint64_t hash = 0;
  for (const std::uint8_t byte : paper_scene(1, 2).rgb) hash = mix64(hash ^ byte);
  EXPECT_EQ(hash_text(hash), "6cb2c635c1534da5");
}

TEST(Picture, RefusesSizesAndSamplesOutOfRange) {
  const Tableau tableau{kRoom, {}, {}};
  EXPECT_EQ(trace_picture(tableau, {.width = 0}).status().setting, "width");
  EXPECT_EQ(trace_picture(tableau, {.height = 20'000}).status().setting, "height");
  EXPECT_EQ(trace_picture(tableau, {.samples = 0}).status().setting, "samples");
}

TEST(Picture, OfAnEmptyWorldShowsItsFrame) {
  const Image empty = traced({kRoom, {}, {}});
  const auto [darkest, brightest] = std::minmax_element(empty.rgb.begin(), empty.rgb.end());
  EXPECT_LT(*darkest, 140);
  EXPECT_GT(*brightest, 220);
}

TEST(Tableau, MarksTheBodiesOfOverlappingBoxesOnly) {
  FakeFrames frames = meeting_cubes();
  const Aabb world{{-10, -10, -10}, {10, 10, 10}};
  EXPECT_EQ(tableau_of(frames, world).colliding, (std::vector<bool>{true, true}));
  ASSERT_TRUE(frames.advance());
  const Tableau apart = tableau_of(frames, world);
  EXPECT_EQ(apart.colliding, (std::vector<bool>{false, false}));
  EXPECT_EQ(apart.bodies[1], (BodyPose{{5.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}}));
}

TEST(Tableau, LeavesWallsOutUnlessThereIsNothingElse) {
  const Aabb floor{{0, -1, 0}, {10, 0, 10}};
  const Aabb box{{4, 0, 4}, {5, 1, 5}};
  const FakeFrames both({{floor, box}});
  const Tableau tableau = tableau_of(both, kRoom);
  ASSERT_EQ(tableau.bodies.size(), 1U);
  EXPECT_TRUE(tableau.colliding[0]) << "it stands on the floor";
  EXPECT_EQ(tableau_of(FakeFrames({{floor}}), kRoom).bodies.size(), 1U);
}

TEST(Tableau, FramesWhatStandsBetweenTheWallsOfARecording) {
  Recording recording;
  recording.world = kRoom;
  recording.bodies = 2;
  recording.boxes = {
      {{0, -1, 0}, {10, 0, 10}}, {{4, 0, 4}, {5, 1, 5}}, {{0, -1, 0}, {10, 0, 10}}, {{6, 1, 4}, {7, 3, 5}}};
  EXPECT_EQ(stage_of(FrameFile(recording)), (Aabb{{4, 0, 4}, {7, 3, 5}}));
  recording.bodies = 1;
  recording.boxes = {{{4, 0, 4}, {5, 1, 5}}};
  EXPECT_EQ(stage_of(FrameFile(recording)), kRoom);
}

TEST(Png, StartsAsAPngFileAndIsTheSameForTheSamePicture) {
  const Image image{2, 1, {255, 0, 0, 0, 0, 255}};
  const std::string png = png_of(image);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png, png_of(image));
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\2\0\0\0\1", 8)) << "width and height";
}

TEST(Png, SaysWhereItCannotBeWritten) {
  const Status status = write_png({1, 1, {0, 0, 0}}, "/no/such/folder/a.png");
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, HasSubstr("/no/such/folder/a.png"));
}

}  // namespace
}  // namespace cellsweep::report
