#include "world/files/aabbs_file.h"

#include <algorithm>
#include <limits>

#include "world/files/file_bytes.h"
#include "world/recording_matchers.h"

namespace cellsweep {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t kBodies = 256;
constexpr std::size_t kFrames = 260;
constexpr std::size_t kReserved = 264;
constexpr std::size_t kWorld = 272;
constexpr std::size_t kBoxes = 304;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::int32_t kMostCounted = std::numeric_limits<std::int32_t>::max();

void append_box(FileBytes& file, float min, float max) {
  file.numbers({min, min + 1, min + 2, 0.0F, max, max + 1, max + 2, 0.0F});
}

/// Two bodies in three frames.
FileBytes small_file() {
  FileBytes file;
  file.field("pile", 128).field("cubes", 128).numbers<std::int32_t>({2, 2, 0, 0});
  append_box(file, -8, 8);
  for (int box = 0; box < 6; ++box) append_box(file, static_cast<float>(box), static_cast<float>(box) + 0.5F);
  return file;
}

TEST(AabbsFile, TheHeaderAndEveryBoxAreRead) {
  const Result<Recording> recording = parse_aabbs(small_file().bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->name, "pile");
  EXPECT_EQ(recording->type, "cubes");
  EXPECT_EQ(recording->world, (Aabb{{-8, -7, -6}, {8, 9, 10}}));
  EXPECT_EQ(recording->bodies, 2U);
  EXPECT_EQ(recording->frames(), 3U);
  EXPECT_EQ(recording->frame(0)[1], (Aabb{{1, 2, 3}, {1.5, 2.5, 3.5}}));
  EXPECT_EQ(recording->frame(2)[0], (Aabb{{4, 5, 6}, {4.5, 5.5, 6.5}}));
}

TEST(AabbsFile, WhatTheWriterMakesIsTheFileByteForByte) {
  const FileBytes file = small_file();
  const Result<Recording> recording = parse_aabbs(file.bytes());
  ASSERT_TRUE(recording.ok());
  const auto written = aabbs_bytes(*recording);
  ASSERT_TRUE(written.ok()) << written.status().message;
  EXPECT_TRUE(std::ranges::equal(*written, file.bytes()));
}

TEST(AabbsFile, AHeaderOfNoUpdatesHasFrameZeroAlone) {
  const Result<Recording> recording = parse_aabbs(small_file().put(kFrames, 0).cut(kBoxes + 64).bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->frames(), 1U);
}

TEST(AabbsFile, NoBodiesAreReadAsNoFramesWhateverTheirNumber) {
  const Result<Recording> recording =
      parse_aabbs(small_file().put(kBodies, 0).put(kFrames, kMostCounted).cut(kBoxes).bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->bodies, 0U);
  EXPECT_EQ(recording->frames(), 0U);
  EXPECT_THAT(parse_aabbs(small_file().put(kBodies, 0).bytes()), RefusedWith(StartsWith("byte 304: ")));
}

TEST(AabbsFile, NegativeZeroDenormalsAndTheLargestFloatsKeepTheirBits) {
  FileBytes file = small_file();
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  constexpr float kLargest = std::numeric_limits<float>::max();
  file.put(kBoxes, -0.0F).put(kBoxes + 4, -kDenormal).put(kBoxes + 8, -kLargest);
  file.put(kBoxes + 16, kDenormal).put(kBoxes + 20, -0.0F).put(kBoxes + 24, kLargest);
  const Result<Recording> recording = parse_aabbs(file.bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(bits_of(recording->boxes)[0], 0x80000000U);
  EXPECT_EQ(bits_of(recording->boxes)[3], 1U);
  const auto written = aabbs_bytes(*recording);
  ASSERT_TRUE(written.ok());
  EXPECT_TRUE(std::ranges::equal(*written, file.bytes()));
}

TEST(AabbsFile, BytesAfterTheEndOfANameAreIgnored) {
  const Result<Recording> recording = parse_aabbs(small_file().fill(5, 123, '\xff').bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->name, "pile");
}

TEST(AabbsFile, EveryTruncationIsRefusedAtTheByteWhereItEnds) {
  const FileBytes file = small_file();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const auto expected = "byte " + std::to_string(size) + ": expected ";
    EXPECT_THAT(parse_aabbs(file.bytes().first(size)),
                RefusedWith(testing::AllOf(StartsWith(expected), HasSubstr("found the end of the file"))));
  }
}

TEST(AabbsFile, TrailingBytesAreRefusedAndCounted) {
  EXPECT_THAT(parse_aabbs(small_file().zeros(1).bytes()),
              RefusedWith(testing::AllOf(StartsWith("byte 496: "), HasSubstr("found 1 more bytes"))));
  EXPECT_THAT(parse_aabbs(small_file().zeros(64).bytes()), RefusedWith(HasSubstr("found 64 more bytes")));
}

TEST(AabbsFile, NegativeCountsAreRefused) {
  EXPECT_THAT(
      parse_aabbs(small_file().put(kBodies, -2).bytes()),
      RefusedWith(testing::StrEq("byte 256: expected a number of bodies that is not negative, found -2")));
  EXPECT_THAT(
      parse_aabbs(small_file().put(kFrames, -1).bytes()),
      RefusedWith(testing::StrEq("byte 260: expected a number of frames that is not negative, found -1")));
}

TEST(AabbsFile, CountsFarBeyondTheFileAreRefusedBeforeAnythingIsAllocated) {
  const auto refusal = RefusedWith(HasSubstr("found the end of the file"));
  EXPECT_THAT(parse_aabbs(small_file().put(kBodies, kMostCounted).put(kFrames, kMostCounted).bytes()),
              refusal);
  // 2^29 bodies in 2^30 frames of 32 bytes are 2^64 bytes, which wrap to none.
  EXPECT_THAT(parse_aabbs(small_file().put(kBodies, 1 << 29).put(kFrames, (1 << 30) - 1).cut(kBoxes).bytes()),
              refusal);
}

TEST(AabbsFile, ReservedIntegersMustBeZero) {
  EXPECT_THAT(parse_aabbs(small_file().put(kReserved, 7).bytes()),
              RefusedWith(testing::StrEq("byte 264: expected zero in a reserved field, found 7")));
  EXPECT_THAT(parse_aabbs(small_file().put(kReserved + 4, -1).bytes()),
              RefusedWith(StartsWith("byte 268: ")));
}

TEST(AabbsFile, NamesMustEndWithinTheirField) {
  EXPECT_THAT(parse_aabbs(small_file().fill(0, 128, 'n').bytes()),
              RefusedWith(StartsWith("byte 0: expected a name")));
  EXPECT_THAT(parse_aabbs(small_file().fill(128, 128, 't').bytes()),
              RefusedWith(StartsWith("byte 128: expected a type")));
}

TEST(AabbsFile, ANumberThatIsNotFiniteIsRefusedWhereverItStands) {
  for (const std::size_t place : {0, 4, 8, 16, 20, 24}) {
    // Frame 1, body 1 is the fourth box.
    const std::size_t offset = kBoxes + std::size_t{3} * 32 + place;
    for (const float number : {kNan, kInfinity, -kInfinity}) {
      const Result<Recording> recording = parse_aabbs(small_file().put(offset, number).bytes());
      EXPECT_THAT(recording, RefusedWith(StartsWith("byte " + std::to_string(offset) +
                                                    " (frame 1, body 1): expected a finite m")));
      EXPECT_EQ(recording.status().body, 1U);
    }
  }
}

TEST(AabbsFile, ABoxThatIsInsideOutIsRefusedOnEachAxis) {
  for (const std::size_t place : {0, 4, 8}) {
    const std::size_t offset = kBoxes + place;
    EXPECT_THAT(
        parse_aabbs(small_file().put(offset, 100.0F).bytes()),
        RefusedWith(StartsWith("byte " + std::to_string(offset) + " (frame 0, body 0): expected min")));
  }
  EXPECT_THAT(parse_aabbs(small_file().put(kBoxes + 4, 100.0F).bytes()),
              RefusedWith(HasSubstr("expected min y <= max y, found 100 > 1.5")));
}

TEST(AabbsFile, TheFourthFloatOfACornerMustBeZero) {
  EXPECT_THAT(parse_aabbs(small_file().put(kBoxes + 12, 1.0F).bytes()),
              RefusedWith(StartsWith("byte 316 (frame 0, body 0): expected zero")));
  EXPECT_THAT(parse_aabbs(small_file().put(kBoxes + 28, kNan).bytes()), RefusedWith(StartsWith("byte 332 ")));
}

TEST(AabbsFile, TheWorldIsCheckedAsABox) {
  EXPECT_THAT(parse_aabbs(small_file().put(kWorld + 4, kNan).bytes()),
              RefusedWith(StartsWith("byte 276: expected a finite min y of the world")));
  EXPECT_THAT(parse_aabbs(small_file().put(kWorld, 9.0F).bytes()), RefusedWith(StartsWith("byte 272: ")));
}

Recording one_box() {
  Recording recording;
  recording.bodies = 1;
  recording.boxes = {{{0, 0, 0}, {1, 1, 1}}};
  return recording;
}

TEST(AabbsFile, ANameOf127BytesFitsAndALongerOneIsRefused) {
  Recording recording = one_box();
  recording.name = std::string(127, 'n');
  const auto written = aabbs_bytes(recording);
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(parse_aabbs(*written)->name, recording.name);
  recording.name += 'n';
  EXPECT_THAT(aabbs_bytes(recording), RefusedWith(HasSubstr("128 bytes, and a file holds 127")));
  recording.name = "";
  recording.type = std::string(128, 't');
  EXPECT_THAT(aabbs_bytes(recording), RefusedWith(HasSubstr("type")));
}

TEST(AabbsFile, ANameWithANulIsNotCutButRefused) {
  Recording recording = one_box();
  recording.name = std::string("a\0b", 3);
  EXPECT_THAT(aabbs_bytes(recording), RefusedWith(HasSubstr("NUL")));
}

TEST(AabbsFile, AWorldThatNoReaderWouldTakeIsNotWritten) {
  Recording recording = one_box();
  recording.world.max[1] = kNan;
  EXPECT_THAT(aabbs_bytes(recording), RefusedWith(HasSubstr("world")));
}

}  // namespace
}  // namespace cellsweep
