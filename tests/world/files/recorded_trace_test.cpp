/// @file
/// Traces that stay in their files: the same frames, and the same refusals, as of those in memory, and no
/// more memory for more frames.
#include "world/files/recorded_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cellsweep/world/frame_file.h"
#include "cellsweep/world/scene.h"
#include "cellsweep/world/trace.h"
#include "world/recording_matchers.h"
#include "world/same_frames.h"
#include "world/traces.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Each test in an empty folder of its own.
class RecordedTraceTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!traces_have_files()) GTEST_SKIP() << "a build without libzip";
    folder_ = fs::path("recorded-trace") / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    path_ = folder_ / "recorded.npz";
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    return all;
  }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
  fs::path path_;
};

TEST_F(RecordedTraceTest, TellsWhatTheSourceToldThatItWasWrittenOf) {
  for (const SceneInfo& scene : scene_table()) {
    SceneSettings settings{.scene = std::string(scene.name), .bodies = 150};
    settings.rest_is_static = true;
    settings.groups = 3;
    const auto written = write_frame_file(**make_scene_frames(settings), 19, {}, path_);
    ASSERT_TRUE(written.ok()) << written.status().message;
    const auto file = read_frame_file(path_);
    ASSERT_TRUE(file.ok()) << file.status().message;
    EXPECT_EQ(written->frames, 20U);
    EXPECT_EQ(file->frames(), 20U);
    EXPECT_EQ(file->ids(), written->ids);
    expect_same_frames(**make_scene_frames(settings), *file->make_source(), 20);
  }
}

TEST_F(RecordedTraceTest, IsTheSameFileAsOfTheTraceInMemory) {
  const SceneSettings settings{.scene = "open-world", .bodies = 200, .groups = 2};
  ASSERT_TRUE(write_frame_file(**make_scene_frames(settings), 30, {}, path_).ok());
  const std::string streamed = bytes();
  ASSERT_TRUE(write_trace(record_trace(**make_scene_frames(settings), 30), path_).ok());
  EXPECT_EQ(bytes(), streamed);
}

TEST_F(RecordedTraceTest, KnowsItsIdsItsWorldAndThatBodiesComeAndGo) {
  const Trace trace = three_bodies_and_two_more();
  ASSERT_TRUE(write_trace(trace, path_).ok());
  const auto recorded = RecordedTrace::open(path_);
  ASSERT_TRUE(recorded.ok());
  EXPECT_EQ(recorded->ids(), trace.ids());
  EXPECT_EQ(recorded->frames(), 3U);
  EXPECT_EQ(recorded->world(), (Aabb{{0, 0, 0}, {21, 21, 21}}));
  EXPECT_TRUE(recorded->summary().bodies_come_and_go);
  EXPECT_TRUE(recorded->summary().has_filters);
  std::size_t boxes = 0;
  EXPECT_TRUE(recorded->for_each_box([&](const Aabb&) { ++boxes; }).ok());
  EXPECT_EQ(boxes, 7U);
}

TEST_F(RecordedTraceTest, HasSourcesThatKnowNothingOfEachOther) {
  ASSERT_TRUE(write_trace(three_bodies_and_two_more(), path_).ok());
  const auto file = read_frame_file(path_);
  ASSERT_TRUE(file.ok());
  const auto ahead = file->make_source();
  ASSERT_TRUE(ahead->advance());
  const auto behind = file->make_source();
  EXPECT_THAT(behind->bodies(), ElementsAre(0, 1, 2));
  EXPECT_THAT(ahead->bodies(), ElementsAre(1, 2, 5));
  ASSERT_TRUE(ahead->advance());
  EXPECT_FALSE(ahead->advance());
  EXPECT_THAT(ahead->bodies(), ElementsAre(0, 1, 5)) << "after the last frame nothing changes";
  EXPECT_TRUE(ahead->status().ok());
}

TEST_F(RecordedTraceTest, IsWhollyRefusedForAByteThatIsWrongAtItsEnd) {
  ASSERT_TRUE(write_frame_file(**make_scene_frames({.scene = "uniform", .bodies = 50}), 9, {}, path_).ok());
  std::string broken = bytes();
  const std::size_t last = broken.find("moved_ends.npy");
  ASSERT_NE(last, std::string::npos);
  broken[last + std::string_view("moved_ends.npy").size() + 30] ^= 1;
  std::ofstream(path_, std::ios::binary) << broken;
  EXPECT_THAT(read_frame_file(path_), RefusedWith(StartsWith(path_.string() + ": ")));
  EXPECT_THAT(read_trace(path_), RefusedWith(StartsWith(path_.string() + ": ")));
}

TEST_F(RecordedTraceTest, EndsInWordsWhereTheFileIsCutOrChangedWhileItIsRead) {
  const SceneSettings settings{.scene = "uniform", .bodies = 400, .moving = 1.0};
  ASSERT_TRUE(write_frame_file(**make_scene_frames(settings), 99, {}, path_).ok());
  const auto file = read_frame_file(path_);
  ASSERT_TRUE(file.ok());
  const auto frames = file->make_source();
  fs::resize_file(path_, fs::file_size(path_) / 2);
  std::size_t seen = 1;
  while (frames->advance()) ++seen;
  EXPECT_LT(seen, 100U);
  EXPECT_EQ(frames->status().code, StatusCode::bad_input);
  EXPECT_THAT(frames->status().message, StartsWith(path_.string() + ": "));
  EXPECT_EQ(frames->bodies().size(), 400U) << "the frame that it stands at stays";
  EXPECT_FALSE(write_frame_file(*frames, 9, {}, folder_ / "other.npz").ok());
  EXPECT_THAT(names(), ElementsAre("recorded.npz"));
}

/// Puts other bytes into a file without making another one.
void overwrite(const fs::path& path, const fs::path& with) {
  std::ifstream from(with, std::ios::binary);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << from.rdbuf();
}

TEST_F(RecordedTraceTest, ThatBecameAnotherOneGivesNoFrameOfThat) {
  const fs::path other = folder_ / "other.npz";
  ASSERT_TRUE(write_trace(three_bodies_and_two_more(), path_).ok());
  const auto file = read_frame_file(path_);
  ASSERT_TRUE(file.ok());
  Trace more_ids = three_bodies_and_two_more();
  more_ids.inserted[3] = more_ids.moved[1] = 7;
  Trace more_frames = three_bodies_and_two_more();
  for (auto* ends : {&more_frames.inserted_ends, &more_frames.removed_ends, &more_frames.moved_ends})
    ends->push_back(ends->back());
  Trace no_filters = three_bodies_and_two_more();
  no_filters.inserted_filters.clear();
  for (const Trace& trace : {more_ids, more_frames, no_filters}) {
    ASSERT_TRUE(write_trace(trace, other).ok());
    const std::uintmax_t size = fs::file_size(path_);
    std::string bytes_before = bytes();
    overwrite(path_, other);
    const auto frames = file->make_source();
    while (frames->advance()) {
    }
    EXPECT_FALSE(frames->status().ok()) << fs::file_size(path_) << " bytes, " << size << " before";
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes_before;
  }
}

/// So many bodies, of which all move in every frame.
class Marching final : public FrameSource {
 public:
  explicit Marching(std::size_t bodies) : boxes_(bodies), moved_(bodies) {
    for (std::size_t body = 0; body < bodies; ++body) moved_[body] = static_cast<BodyId>(body);
  }

  std::string name() const override { return "marching"; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> moved() const override {
    return frame_ == 0 ? std::span<const BodyId>() : std::span<const BodyId>(moved_);
  }
  bool advance() override {
    const auto step = static_cast<float>(++frame_ % 2);
    for (Aabb& box : boxes_) box = cube(step);
    return true;
  }

 private:
  std::size_t frame_ = 0;
  std::vector<Aabb> boxes_;
  std::vector<BodyId> moved_;
};

/// While it lives, this process gets no more than so many bytes of addresses beside those that it has.
class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t more) {
    getrlimit(RLIMIT_AS, &before_);
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit limit{pages * 4096 + more, before_.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

// 3,000 frames of 1,000 boxes that move: 84 MB in the trace's arrays, 72 MB in a recording's, in 16 MiB.
TEST_F(RecordedTraceTest, OfMoreFramesThanMemoryHoldsIsWrittenAndRead) {
#if defined(CELLSWEEP_SANITIZED_TESTS) || defined(CELLSWEEP_EMULATED_TESTS)
  GTEST_SKIP() << "a sanitizer, and an emulator, needs the addresses for itself";
#endif
  constexpr std::size_t kUpdates = 2'999;
  const MemoryLimit limit(rlim_t{16} << 20);
  for (const char* name : {"long.npz", "long.npy", "long.aabbs"}) {
    Marching source(1'000);
    const auto written = write_frame_file(source, kUpdates, cube(0), folder_ / name);
    ASSERT_TRUE(written.ok()) << written.status().message;
    EXPECT_EQ(written->frames, kUpdates + 1);
    const auto file = read_frame_file(folder_ / name);
    ASSERT_TRUE(file.ok()) << file.status().message;
    const auto frames = file->make_source();
    std::size_t moved = 0;
    while (frames->advance()) moved += frames->moved().size();
    EXPECT_EQ(moved, kUpdates * 1'000);
    EXPECT_TRUE(frames->status().ok());
    EXPECT_EQ(frames->boxes()[999], cube(1));
  }
}

TEST_F(RecordedTraceTest, IsNotThereWhenAFrameOfItsSourceIsBad) {
  for (const char* name : {"bad.npz", "bad.npy", "bad.aabbs"}) {
    class Broken final : public FrameSource {
     public:
      std::string name() const override { return "broken"; }
      std::span<const Aabb> boxes() const override { return {&box_, 1}; }
      std::span<const BodyId> moved() const override {
        return frame_ == 0 ? std::span<const BodyId>() : std::span<const BodyId>(&id_, 1);
      }
      bool advance() override {
        if (++frame_ == 3) box_.max[1] = -1;
        return true;
      }

     private:
      std::size_t frame_ = 0;
      BodyId id_ = 0;
      Aabb box_;
    } source;
    const auto written = write_frame_file(source, 9, {}, folder_ / name);
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.status().code, StatusCode::bad_input);
    EXPECT_THAT(written.status().message,
                AllOf(StartsWith((folder_ / name).string() + ": "), HasSubstr("expected min y <= max y")));
    EXPECT_THAT(names(), IsEmpty());
  }
}

TEST_F(RecordedTraceTest, RefusesIdsThatNobodyWouldRead) {
  Trace trace;
  trace.inserted = {1 << 20};
  trace.inserted_boxes = {cube(0)};
  trace.inserted_ends = {1};
  trace.removed_ends = trace.moved_ends = {0};
  const auto source = make_trace_frames(std::make_shared<const Trace>(trace));
  const auto written = write_frame_file(*source, 0, {}, path_);
  EXPECT_THAT(written.status().message, HasSubstr("inserted[0] (frame 0): expected an id below 1048576"));
  EXPECT_THAT(names(), IsEmpty());
}

}  // namespace
}  // namespace cellsweep
