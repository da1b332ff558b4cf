/// @file
/// Recordings that stay in their files: the same frames, and the same refusals, as of those in memory.
#include "world/files/recorded_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/scene.h"
#include "world/recording_matchers.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Each test in an empty folder of its own, with a recording in it.
class RecordedFramesTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    for (char& letter : name) letter = letter == '/' ? '-' : letter;
    const fs::path folder = fs::path("recorded-frames") / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    path_ = folder / ("recorded" + GetParam());
    const SceneSettings settings{.bodies = 40, .moving = 0.5};
    recording_ = *record(**make_scene_frames(settings), 9, *scene_bounds(settings));
    recording_.name = "recorded";
    ASSERT_TRUE(write_recording(recording_, path_).ok());
  }

  fs::path path_;
  Recording recording_;
};

TEST_P(RecordedFramesTest, AreThoseOfTheRecordingInMemory) {
  const Result<FrameFile> file = read_frame_file(path_);
  ASSERT_TRUE(file.ok()) << file.status().message;
  const Recording read = *read_recording(path_);
  EXPECT_EQ(file->frames(), 10U);
  EXPECT_EQ(file->ids(), 40U);
  EXPECT_EQ(file->world(), read.world);
  const auto in_file = file->make_source();
  const auto in_memory = make_recording_frames(recording_);
  EXPECT_EQ(in_file->name(), in_memory->name());
  for (bool more = true; more;) {
    EXPECT_TRUE(std::ranges::equal(in_file->boxes(), in_memory->boxes()));
    EXPECT_TRUE(std::ranges::equal(in_file->moved(), in_memory->moved()));
    more = in_memory->advance();
    EXPECT_EQ(in_file->advance(), more);
  }
  EXPECT_TRUE(in_file->status().ok());
}

TEST_P(RecordedFramesTest, ShowEveryBoxInItsOrder) {
  std::vector<Aabb> boxes;
  ASSERT_TRUE(read_frame_file(path_)->for_each_box([&](const Aabb& box) { boxes.push_back(box); }).ok());
  EXPECT_EQ(boxes, recording_.boxes);
}

TEST_P(RecordedFramesTest, OfWhichTheLastBoxIsBadAreRefusedBeforeTheFirstIsSeen) {
  const auto size = static_cast<std::streamoff>(fs::file_size(path_));
  std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(size - (GetParam() == ".npy" ? 4 : 8));  // the upper corner's z
  file.write("\0\0\xc0\x7f", 4);
  file.close();
  EXPECT_THAT(read_frame_file(path_),
              RefusedWith(AllOf(StartsWith(path_.string() + ": byte "),
                                HasSubstr("(frame 9, body 39): expected a finite max z, found nan"))));
}

TEST_P(RecordedFramesTest, EndInWordsWhereTheFileIsCutWhileItIsRead) {
  const Result<FrameFile> file = read_frame_file(path_);
  ASSERT_TRUE(file.ok());
  const auto frames = file->make_source();
  fs::resize_file(path_, fs::file_size(path_) / 2);
  std::size_t seen = 1;
  while (frames->advance()) ++seen;
  EXPECT_LT(seen, 7U);
  EXPECT_GT(seen, 2U);
  EXPECT_EQ(frames->status().code, StatusCode::bad_input);
  EXPECT_THAT(frames->status().message, AllOf(StartsWith(path_.string()), HasSubstr("while it was read")));
  EXPECT_FALSE(record(*frames, 9, recording_.world).ok());
}

TEST_P(RecordedFramesTest, OfAHundredGigabytesThatTheHeadDoesNotSpeakOfAreRefusedUnread) {
  std::error_code error;
  fs::resize_file(path_, 100'000'000'000, error);
  if (error) GTEST_SKIP() << "no room for a file with a hole";
  EXPECT_THAT(read_frame_file(path_), RefusedWith(HasSubstr("more bytes")));
  EXPECT_THAT(read_recording(path_), RefusedWith(HasSubstr("more bytes")));
}

INSTANTIATE_TEST_SUITE_P(All, RecordedFramesTest, testing::Values(".aabbs", ".npy"),
                         [](const auto& ending) { return ending.param.substr(1); });

TEST(RecordedHead, OfMoreThanAMillionBytesIsRefusedWithThatNumber) {
  std::string file("\x93NUMPY\x02\x00", 8);
  file += std::string("\x41\x42\x0f\x00", 4);
  EXPECT_THAT(parse_npy(std::as_bytes(std::span(file))),
              RefusedWith(HasSubstr("expected a header of at most 1000000 bytes, found one of 1000001")));
}

}  // namespace
}  // namespace cellsweep
