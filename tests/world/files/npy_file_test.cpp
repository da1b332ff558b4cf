#include "world/files/npy_file.h"

#include <algorithm>
#include <limits>

#include "world/files/file_bytes.h"
#include "world/recording_matchers.h"

namespace cellsweep {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kVersion1Text = 10;

/// A file of format version 1.0 whose data is still to come.
FileBytes version_1(std::string_view dictionary) {
  FileBytes file;
  file.text(kMagic).byte(1).byte(0).byte(dictionary.size()).byte(dictionary.size() >> 8);
  return file.text(dictionary);
}

/// A file of format version 2.0 or 3.0 whose data is still to come.
FileBytes version_2_or_3(std::size_t version, std::string_view dictionary) {
  FileBytes file;
  file.text(kMagic).byte(version).byte(0).number(static_cast<std::uint32_t>(dictionary.size()));
  return file.text(dictionary);
}

std::string dictionary_of(const std::string& type, const std::string& shape = "(2, 1, 6)") {
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
}

template <class Number>
FileBytes& two_boxes(FileBytes& file, bool big_endian = false) {
  return file.numbers<Number>({0, 1, 2, 3, 4, 5, -1.5, 1, 2, 3, 4, 1024.25}, big_endian);
}

void expect_two_boxes(const FileBytes& file) {
  const Result<Recording> recording = parse_npy(file.bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->frames(), 2U);
  EXPECT_EQ(recording->bodies, 1U);
  EXPECT_EQ(recording->frame(0)[0], (Aabb{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(recording->frame(1)[0], (Aabb{{-1.5F, 1, 2}, {3, 4, 1024.25F}}));
  EXPECT_EQ(recording->world, (Aabb{{-1.5F, 1, 2}, {3, 4, 1024.25F}}));
}

TEST(NpyFile, BothTypesInBothByteOrdersAreRead) {
  FileBytes file = version_1(dictionary_of("<f4"));
  expect_two_boxes(two_boxes<float>(file));
  file = version_1(dictionary_of("<f8"));
  expect_two_boxes(two_boxes<double>(file));
  file = version_1(dictionary_of(">f4"));
  expect_two_boxes(two_boxes<float>(file, true));
  file = version_1(dictionary_of(">f8"));
  expect_two_boxes(two_boxes<double>(file, true));
}

TEST(NpyFile, VersionsTwoAndThreeAreRead) {
  for (const std::size_t version : {2, 3}) {
    FileBytes file = version_2_or_3(version, dictionary_of("<f4"));
    expect_two_boxes(two_boxes<float>(file));
  }
}

TEST(NpyFile, AHeaderPastVersionOnesLengthIsReadFromVersionTwo) {
  FileBytes file = version_2_or_3(2, dictionary_of("<f4") + std::string(70000, ' '));
  expect_two_boxes(two_boxes<float>(file));
}

TEST(NpyFile, KeysComeInAnyOrderQuotesAndSpacing) {
  const std::string spellings[] = {
      "{'shape':(2,1,6),'fortran_order':False,'descr':'<f4'}",
      " {\n\t\"fortran_order\" : False , \"shape\" : ( 2 , 1 , 6 , ) ,\r\n \"descr\" : \"<f4\" , } \n",
  };
  for (const std::string& spelling : spellings) {
    FileBytes file = version_1(spelling);
    expect_two_boxes(two_boxes<float>(file));
  }
}

TEST(NpyFile, Float64IsRoundedToTheNearestFloat32) {
  FileBytes file = version_1(dictionary_of("<f8", "(1, 1, 6)"));
  // 2^24 + 1 lies half way and goes to the even neighbour; 2^24 + 1.5 is nearer to the upper one.
  file.numbers<double>({0.1, 16777217.0, -0.0, 1.0, 16777217.5, 1e-50});
  const Result<Recording> recording = parse_npy(file.bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(bits_of(recording->boxes),
            (std::vector<std::uint32_t>{0x3dcccccd, 0x4b800000, 0x80000000, 0x3f800000, 0x4b800001, 0}));
}

TEST(NpyFile, Float64PastTheRangeOfFloat32IsRefusedAtItsByte) {
  const FileBytes header = version_1(dictionary_of("<f8", "(1, 1, 6)"));
  const std::size_t offset = header.size() + std::size_t{3} * 8;
  constexpr double kLargest = std::numeric_limits<float>::max();
  constexpr double kHalfStep = 0x1p103;
  FileBytes fits = header;
  EXPECT_TRUE(parse_npy(fits.numbers<double>({0, 0, 0, kLargest + 0.99 * kHalfStep, 1, 1}).bytes()).ok());
  FileBytes beyond = header;
  EXPECT_THAT(
      parse_npy(beyond.numbers<double>({0, 0, 0, kLargest + kHalfStep, 1, 1}).bytes()),
      RefusedWith(StartsWith("byte " + std::to_string(offset) +
                             " (frame 0, body 0): expected max x within the range of float32, found 3.4")));
}

TEST(NpyFile, NegativeZeroAndDenormalsKeepTheirBits) {
  FileBytes file = version_1(dictionary_of("<f4", "(1, 1, 6)"));
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  file.numbers<float>({-0.0F, -kDenormal, 0, 0, kDenormal, -0.0F});
  const Result<Recording> recording = parse_npy(file.bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(bits_of(recording->boxes),
            (std::vector<std::uint32_t>{0x80000000, 0x80000001, 0, 0, 1, 0x80000000}));
}

TEST(NpyFile, EveryTruncationIsRefused) {
  FileBytes file = version_1(dictionary_of("<f8"));
  two_boxes<double>(file);
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_THAT(parse_npy(file.bytes().first(size)),
                RefusedWith(AllOf(StartsWith("byte " + std::to_string(size) + ": expected "),
                                  HasSubstr("found the end of the file"))));
  }
}

TEST(NpyFile, TrailingBytesAreRefusedAndCounted) {
  FileBytes file = version_1(dictionary_of("<f4"));
  two_boxes<float>(file);
  const std::string end = std::to_string(file.size());
  EXPECT_THAT(parse_npy(file.zeros(3).bytes()),
              RefusedWith(AllOf(StartsWith("byte " + end + ": "), HasSubstr("found 3 more bytes"))));
}

TEST(NpyFile, AnotherMagicOrVersionIsRefused) {
  EXPECT_THAT(parse_npy(FileBytes().text("min,max\n").bytes()), RefusedWith(StartsWith("byte 0: ")));
  EXPECT_THAT(parse_npy(version_2_or_3(4, dictionary_of("<f4")).bytes()),
              RefusedWith(testing::StrEq("byte 6: expected format version 1.0, 2.0 or 3.0, found 4.0")));
  FileBytes minor;
  minor.text(kMagic).byte(1).byte(1).zeros(2);
  EXPECT_THAT(parse_npy(minor.bytes()), RefusedWith(HasSubstr("found 1.1")));
}

/// What a version 1.0 file of this dictionary, with 48 bytes of data, is refused for.
void expect_refusal(const std::string& dictionary, std::size_t position, const std::string& words) {
  const FileBytes file = version_1(dictionary).zeros(48);
  const auto where = "byte " + std::to_string(kVersion1Text + position) + ": ";
  EXPECT_THAT(parse_npy(file.bytes()), RefusedWith(AllOf(StartsWith(where), HasSubstr(words)))) << dictionary;
}

TEST(NpyFile, TypesOtherThanFloatsOfAStatedByteOrderAreRefusedByName) {
  for (const std::string type : {"<i4", "<f2", "=f4", "|f4", "f4", "<f16", ""}) {
    expect_refusal(dictionary_of(type), 10, "found \"" + type + "\"");
  }
  expect_refusal("{'descr': [('min', '<f4', (3,))], ", 10, "expected a string that names the type");
}

TEST(NpyFile, FortranOrderIsRefusedWithTheWayOut) {
  const std::string before = "{'descr': '<f4', 'fortran_order': ";
  expect_refusal(before + "True, 'shape': (2, 1, 6)}", before.size(), "ascontiguousarray");
  expect_refusal(before + "0, 'shape': (2, 1, 6)}", before.size(), "expected True or False");
}

TEST(NpyFile, OtherShapesAreRefusedByName) {
  const std::size_t position = dictionary_of("<f4", "").find(", }");
  for (const std::string shape :
       {"()", "(6,)", "(12, 6)", "(2, 1, 7)", "(2, 6, 1)", "(1, 2, 1, 6)", "(2, 1, 6, 1)"}) {
    expect_refusal(dictionary_of("<f4", shape), position,
                   "expected shape (frames, bodies, 6), found shape \"" + shape + "\"");
  }
  expect_refusal(dictionary_of("<f4", "(0, 2, 6)"), position, "expected at least one frame");
  expect_refusal(dictionary_of("<f4", "(1, 4294967297, 6)"), position, "32-bit ids");
  expect_refusal(dictionary_of("<f4", "(-1, 2, 6)"), position + 1, "expected a number");
  expect_refusal(dictionary_of("<f4", "(18446744073709551616, 2, 6)"), position + 1, "18446744073709551615");
  expect_refusal(dictionary_of("<f4", "(1 2 6)"), position + 3, "',' or ')'");
  expect_refusal(dictionary_of("<f4", "[1, 2, 6]"), position, "'('");
  expect_refusal(dictionary_of("<f4", "(,)"), position + 1, "expected a number");
}

TEST(NpyFile, AShapeWhoseProductWrapsIsRefused) {
  // 2^63 + 1 frames of 2 boxes are 2^64 + 2 boxes, which wrap to the 2 boxes of 24 bytes that are there.
  const FileBytes file = version_1(dictionary_of("<f4", "(9223372036854775809, 2, 6)")).zeros(48);
  EXPECT_THAT(parse_npy(file.bytes()), RefusedWith(HasSubstr("found the end of the file")));
  const FileBytes largest =
      version_1(dictionary_of("<f8", "(18446744073709551615, 4294967296, 6)")).zeros(48);
  EXPECT_THAT(parse_npy(largest.bytes()), RefusedWith(HasSubstr("found the end of the file")));
}

TEST(NpyFile, NoBodiesAreReadAsNoFrames) {
  const Result<Recording> recording =
      parse_npy(version_1(dictionary_of("<f4", "(18446744073709551615, 0, 6)")).bytes());
  ASSERT_TRUE(recording.ok()) << recording.status().message;
  EXPECT_EQ(recording->frames(), 0U);
  EXPECT_EQ(recording->world, Aabb{});
}

TEST(NpyFile, TheDictionaryMustHaveTheThreeKeysOnceAndNothingElse) {
  expect_refusal("{}", 1, "found the end of the dictionary");
  expect_refusal("{'descr': '<f4', 'shape': (2, 1, 6)}", 35, "expected key \"fortran_order\"");
  expect_refusal("{'descr': '<f4', 'descr': '<f4'}", 17, "found key \"descr\" again");
  expect_refusal("{'kind': 1}", 1, "found key \"kind\"");
  expect_refusal("{'descr' '<f4'}", 9, "expected ':'");
  expect_refusal("{'descr': '<f4' 'shape'}", 16, "expected ',' or '}'");
  expect_refusal("{descr: '<f4'}", 1, "expected a key in quotes");
  expect_refusal("{'descr", 1, "expected a key in quotes");
  expect_refusal("{,}", 1, "expected a key in quotes");
  expect_refusal("(1,)", 0, "expected the '{'");
  expect_refusal("", 0, "found the end of the header");
  expect_refusal("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1, 6)} 1", 61, "nothing but space");
}

TEST(NpyFile, WhatAMessageQuotesIsPrintableAndShort) {
  expect_refusal("{'\x1b[2J\xff': 1}", 1, "\"?[2J?\"");
  expect_refusal("{'" + std::string(60000, 'k') + "': 1}", 1, "\"" + std::string(48, 'k') + "...\"");
}

TEST(NpyFile, BoxesThatAreNotFiniteOrInsideOutAreRefusedAtTheirByte) {
  const FileBytes header = version_1(dictionary_of(">f8"));
  FileBytes nan = header;
  nan.numbers<double>({0, 0, 0, 1, 1, 1, 0, 0, 0, 1, std::numeric_limits<double>::quiet_NaN(), 1}, true);
  EXPECT_THAT(parse_npy(nan.bytes()), RefusedWith(StartsWith("byte " + std::to_string(header.size() + 80) +
                                                             " (frame 1, body 0): expected a finite max y")));
  FileBytes reversed = header;
  reversed.numbers<double>({0, 0, 1.0000000001, 1, 1, 1, 0, 0, 0, 1, 1, 1}, true);
  EXPECT_THAT(parse_npy(reversed.bytes()),
              RefusedWith(StartsWith("byte " + std::to_string(header.size() + 16) +
                                     " (frame 0, body 0): expected min z <= max z")));
}

TEST(NpyFile, TheWriterMakesTheBytesThatNumPyMakes) {
  Recording recording;
  recording.bodies = 1;
  recording.boxes = {{{0, 1, 2}, {3, 4, 5}}, {{-1.5F, 1, 2}, {3, 4, 1024.25F}}};
  // numpy.save() pads the header with spaces to a multiple of 64 bytes.
  std::string dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1, 6), }";
  dictionary.resize(128 - kVersion1Text - 1, ' ');
  FileBytes expected = version_1(dictionary + "\n");
  two_boxes<float>(expected);
  const auto written = npy_bytes(recording);
  ASSERT_TRUE(written.ok()) << written.status().message;
  EXPECT_TRUE(std::ranges::equal(*written, expected.bytes()));
}

}  // namespace
}  // namespace cellsweep
