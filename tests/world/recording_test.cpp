#include "cellsweep/world/recording.h"

#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "cellsweep/pair.h"
#include "cellsweep/world/scene.h"
#include "project_file.h"
#include "world/recording_matchers.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const fs::path kPile = project_file("bench/scenes/bullet-pile-1024.aabbs");

Aabb cube(float at) {
  return {{at, at, at}, {at + 1, at + 1, at + 1}};
}

Recording three_frames() {
  Recording recording;
  recording.name = "three";
  recording.type = "cubes";
  recording.world = {{-9, -9, -9}, {9, 9, 9}};
  recording.bodies = 2;
  recording.boxes = {cube(0), cube(5), cube(0), cube(4), cube(-0.5F), cube(3)};
  return recording;
}

std::vector<Pair> brute_force(std::span<const Aabb> boxes) {
  std::vector<Pair> pairs;
  for (BodyId a = 0; a < boxes.size(); ++a) {
    for (BodyId b = a + 1; b < boxes.size(); ++b) {
      if (overlap(boxes[a], boxes[b])) pairs.push_back({a, b});
    }
  }
  return pairs;
}

TEST(Recording, TheCutOfThePileHasItsKnownPairs) {
  const Result<Recording> pile = read_recording(kPile);
  ASSERT_TRUE(pile.ok()) << pile.status().message;
  EXPECT_EQ(pile->name, "bullet-pile");
  EXPECT_EQ(pile->type, "rigid bodies, 60 Hz");
  EXPECT_EQ(pile->bodies, 1024U);
  ASSERT_EQ(pile->frames(), 31U);

  struct Golden {
    std::size_t frame;
    std::size_t pairs;
    std::uint64_t hash;
  };
  for (const Golden& golden : {Golden{0, 5577, 0x875cb2208a071dd3}, Golden{15, 4914, 0xadd61a14b776a039},
                               Golden{30, 3901, 0xc05c583740ead6b9}}) {
    const std::vector<Pair> pairs = brute_force(pile->frame(golden.frame));
    EXPECT_EQ(pairs.size(), golden.pairs) << "frame " << golden.frame;
    EXPECT_EQ(pair_set_hash(pairs), golden.hash) << "frame " << golden.frame;
  }
}

TEST(Recording, EveryFileOfTheCorpusIsAcceptedOrRefusedAsItsNameSays) {
  std::size_t files = 0;
  for (const std::string folder : {"aabbs", "npy"}) {
    for (const auto& entry : fs::directory_iterator(project_file("tests/fuzz/corpus/" + folder))) {
      const std::string name = entry.path().filename().string();
      const Result<Recording> recording = read_recording(entry.path());
      ++files;
      if (name.starts_with("valid-")) {
        EXPECT_TRUE(recording.ok()) << recording.status().message;
      } else {
        EXPECT_THAT(recording, RefusedWith(StartsWith(entry.path().string() + ": byte "))) << name;
      }
    }
  }
  EXPECT_GE(files, 70U);
}

TEST(RecordingFrames, EveryFrameComesOnceWithTheBodiesThatMoved) {
  const auto frames = make_recording_frames(three_frames());
  EXPECT_EQ(frames->name(), "three");
  EXPECT_THAT(frames->boxes(), ElementsAre(cube(0), cube(5)));
  EXPECT_THAT(frames->moved(), IsEmpty());
  ASSERT_TRUE(frames->advance());
  EXPECT_THAT(frames->boxes(), ElementsAre(cube(0), cube(4)));
  EXPECT_THAT(frames->moved(), ElementsAre(1));
  ASSERT_TRUE(frames->advance());
  EXPECT_THAT(frames->moved(), ElementsAre(0, 1));
}

TEST(RecordingFrames, AfterTheLastFrameNothingChanges) {
  const auto frames = make_recording_frames(three_frames());
  ASSERT_TRUE(frames->advance() && frames->advance());
  EXPECT_FALSE(frames->advance());
  EXPECT_FALSE(frames->advance());
  EXPECT_THAT(frames->boxes(), ElementsAre(cube(-0.5F), cube(3)));
  EXPECT_THAT(frames->moved(), ElementsAre(0, 1));
}

TEST(RecordingFrames, ARecordingOfNoBodiesHasOneEmptyFrame) {
  const auto frames = make_recording_frames({});
  EXPECT_THAT(frames->boxes(), IsEmpty());
  EXPECT_FALSE(frames->advance());
}

TEST(Record, AllUpdatesAskedForAreStoredAfterFrameZero) {
  const Recording whole = three_frames();
  const auto frames = make_recording_frames(whole);
  const Recording recorded = *record(*frames, 1, whole.world);
  EXPECT_EQ(recorded.name, "three");
  EXPECT_EQ(recorded.world, whole.world);
  EXPECT_EQ(recorded.bodies, 2U);
  EXPECT_THAT(recorded.boxes, ElementsAre(cube(0), cube(5), cube(0), cube(4)));
}

TEST(Record, ASourceThatEndsEarlyGivesWhatItHas) {
  const Recording whole = three_frames();
  const auto frames = make_recording_frames(whole);
  EXPECT_EQ(record(*frames, 1000, whole.world)->boxes, whole.boxes);
}

TEST(Record, ASourceWhoseBodiesComeAndGoIsRefusedInWords) {
  const auto frames = std::move(*make_scene_frames({.scene = "open-world", .bodies = 10}));
  const Status status = record(*frames, 1, {}).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, HasSubstr("the bodies of open-world come and go"));
}

/// Tests that write: each in an empty folder of its own, below the folder the test runs in.
class RecordingFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path in_folder(const char* name) const { return folder_ / name; }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }

 private:
  fs::path folder_ =
      fs::path("recording-files") / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(RecordingFile, ARoundTripKeepsEveryBitInBothFormats) {
  Recording recording = three_frames();
  recording.boxes[1] = {{-0.0F, 1e-40F, -3.4e38F}, {0.0F, 1e-39F, 3.4e38F}};
  for (const char* name : {"trip.aabbs", "trip.npy"}) {
    const Status written = write_recording(recording, in_folder(name));
    ASSERT_TRUE(written.ok()) << written.message;
    const Result<Recording> read = read_recording(in_folder(name));
    ASSERT_TRUE(read.ok()) << read.status().message;
    EXPECT_EQ(read->bodies, recording.bodies);
    EXPECT_EQ(bits_of(read->boxes), bits_of(recording.boxes));
  }
  EXPECT_THAT(names(), testing::UnorderedElementsAre("trip.aabbs", "trip.npy"));
}

TEST_F(RecordingFile, NameTypeAndWorldComeBackFromAnAabbsFile) {
  ASSERT_TRUE(write_recording(three_frames(), in_folder("other.aabbs")).ok());
  const Result<Recording> read = read_recording(in_folder("other.aabbs"));
  ASSERT_TRUE(read.ok()) << read.status().message;
  EXPECT_EQ(read->name, "three");
  EXPECT_EQ(read->type, "cubes");
  EXPECT_EQ(read->world, three_frames().world);
}

TEST_F(RecordingFile, AnNpyFileGivesItsOwnNameAndTheBoundsOfItsBoxes) {
  ASSERT_TRUE(write_recording(three_frames(), in_folder("falling.npy")).ok());
  const Result<Recording> read = read_recording(in_folder("falling.npy"));
  ASSERT_TRUE(read.ok()) << read.status().message;
  EXPECT_EQ(read->name, "falling");
  EXPECT_EQ(read->world, (Aabb{{-0.5F, -0.5F, -0.5F}, {6, 6, 6}}));
}

TEST_F(RecordingFile, WritingReplacesAnOlderFile) {
  Recording recording = three_frames();
  ASSERT_TRUE(write_recording(recording, in_folder("a.aabbs")).ok());
  recording.boxes.resize(2);
  ASSERT_TRUE(write_recording(recording, in_folder("a.aabbs")).ok());
  EXPECT_EQ(read_recording(in_folder("a.aabbs"))->frames(), 1U);
}

TEST_F(RecordingFile, OtherEndingsAreRefused) {
  const auto refusal = RefusedWith(HasSubstr("expected a name that ends in .aabbs or .npy"));
  EXPECT_THAT(read_recording("scene.obj"), refusal);
  EXPECT_THAT(read_recording("aabbs"), refusal);
  EXPECT_EQ(write_recording(three_frames(), in_folder("a.npz")).code, StatusCode::bad_input);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(RecordingFile, AFileThatIsNotThereAndAFolderAreRefusedByPath) {
  EXPECT_THAT(read_recording(in_folder("none.aabbs")),
              RefusedWith(AllOf(StartsWith(in_folder("none.aabbs").string()), HasSubstr("cannot be read"))));
  fs::create_directory(in_folder("folder.npy"));
  EXPECT_THAT(read_recording(in_folder("folder.npy")),
              RefusedWith(StartsWith(in_folder("folder.npy").string() + ": is not a file")));
}

TEST_F(RecordingFile, AReadersRefusalHasThePathInFront) {
  std::ofstream(in_folder("short.aabbs")) << "abc";
  EXPECT_THAT(read_recording(in_folder("short.aabbs")),
              RefusedWith(StartsWith(in_folder("short.aabbs").string() + ": byte 3: expected a header")));
}

TEST_F(RecordingFile, RecordingsThatContradictThemselvesAreNotWritten) {
  Recording no_frames = three_frames();
  no_frames.boxes.clear();
  Recording half_a_frame = three_frames();
  half_a_frame.boxes.pop_back();
  Recording inside_out = three_frames();
  inside_out.boxes[3].max[2] = -100;
  const std::pair<Recording, const char*> cases[] = {
      {Recording{}, "no frames"},
      {no_frames, "0 boxes for 2 bodies"},
      {half_a_frame, "5 boxes for 2 bodies"},
      {inside_out, "frame 1, body 1: expected min z <= max z"}};
  for (const auto& [recording, words] : cases) {
    for (const char* name : {"bad.aabbs", "bad.npy"}) {
      const Status status = write_recording(recording, in_folder(name));
      EXPECT_EQ(status.code, StatusCode::bad_input);
      EXPECT_THAT(status.message, AllOf(StartsWith(in_folder(name).string()), HasSubstr(words)));
    }
  }
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(RecordingFile, AFolderThatIsNotThereIsNamed) {
  const fs::path path = in_folder("none") / "a.aabbs";
  const Status status = write_recording(three_frames(), path);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, StartsWith(path.string() + ": cannot be written: "));
}

TEST_F(RecordingFile, AWriteOntoAFolderLeavesTheFolderAndNothingElse) {
  fs::create_directory(in_folder("taken.aabbs"));
  EXPECT_EQ(write_recording(three_frames(), in_folder("taken.aabbs")).code, StatusCode::bad_input);
  EXPECT_THAT(names(), ElementsAre("taken.aabbs"));
}

/// While it lives, files of this process cannot grow past a size: a full disk to those who write.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(RecordingFile, ADiskThatIsFullLeavesTheOlderFileAsItWas) {
  ASSERT_TRUE(write_recording(three_frames(), in_folder("a.aabbs")).ok());
  Recording large = three_frames();
  large.boxes.resize(10000, cube(1));
  Status status;
  {
    const FileSizeLimit limit(100000);
    status = write_recording(large, in_folder("a.aabbs"));
  }
  EXPECT_EQ(status.code, StatusCode::write_failed);
  EXPECT_THAT(status.message, HasSubstr("cannot be written"));
  EXPECT_THAT(names(), ElementsAre("a.aabbs"));
  EXPECT_EQ(read_recording(in_folder("a.aabbs"))->frames(), 3U);
}

TEST_F(RecordingFile, ADiskThatIsFullAtTheLastBytesIsNoticedToo) {
  Status status;
  {
    const FileSizeLimit limit(100);
    status = write_recording(three_frames(), in_folder("a.aabbs"));
  }
  EXPECT_EQ(status.code, StatusCode::write_failed);
  EXPECT_THAT(names(), IsEmpty());
}

}  // namespace
}  // namespace cellsweep
