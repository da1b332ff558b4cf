/// @file
/// Traces as .npz: written and read back, hand-made ones read, and all that does not hold together refused.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "cellsweep/world/trace.h"
#include "world/files/file_bytes.h"
#include "world/files/zip_archive.h"
#include "world/recording_matchers.h"
#include "world/traces.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

bool same(const Trace& one, const Trace& other) {
  return one.inserted == other.inserted && bits_of(one.inserted_boxes) == bits_of(other.inserted_boxes) &&
         one.inserted_filters == other.inserted_filters && one.removed == other.removed &&
         one.moved == other.moved && bits_of(one.moved_boxes) == bits_of(other.moved_boxes) &&
         one.inserted_ends == other.inserted_ends && one.removed_ends == other.removed_ends &&
         one.moved_ends == other.moved_ends;
}

/// Each test in an empty folder of its own.
class TraceFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!traces_have_files()) GTEST_SKIP() << "a build without libzip";
    folder_ = fs::path(testing::TempDir()) / "cellsweep-trace-files" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  fs::path in_folder(const char* name) const { return folder_ / name; }

  fs::path folder_;
};

TEST_F(TraceFile, ComesBackBitForBit) {
  const fs::path path = in_folder("five.npz");
  Trace trace = three_bodies_and_two_more();
  trace.moved_boxes[0].min[1] = -0.0F;
  ASSERT_TRUE(write_trace(trace, path).ok());
  const Result<Trace> read = read_trace(path);
  ASSERT_TRUE(read.ok()) << read.status().message;
  EXPECT_TRUE(same(trace, *read));
  EXPECT_EQ(read->name, "five");
}

TEST_F(TraceFile, WithoutFiltersHasNone) {
  Trace trace = three_bodies_and_two_more();
  trace.inserted_filters.clear();
  ASSERT_TRUE(write_trace(trace, in_folder("a.npz")).ok());
  EXPECT_TRUE(same(trace, *read_trace(in_folder("a.npz"))));
}

TEST_F(TraceFile, OfTheSameTraceHasTheSameBytes) {
  const auto bytes_of = [](const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  for (const char* name : {"a.npz", "b.npz"})
    ASSERT_TRUE(write_trace(three_bodies_and_two_more(), in_folder(name)).ok());
  EXPECT_EQ(bytes_of(in_folder("a.npz")), bytes_of(in_folder("b.npz")));
}

TEST_F(TraceFile, IsNotWrittenWhenItDoesNotHoldTogether) {
  Trace trace = three_bodies_and_two_more();
  trace.moved[1] = 2;
  EXPECT_THAT(
      Result<Trace>(write_trace(trace, in_folder("bad.npz"))),
      RefusedWith(HasSubstr("bad.npz: moved[1] (frame 2): expected a body that was there in the frame "
                            "before, found 2, which is removed in this frame")));
  trace = three_bodies_and_two_more();
  trace.inserted_boxes[3].max[0] = -1;
  EXPECT_THAT(Result<Trace>(write_trace(trace, in_folder("bad.npz"))),
              RefusedWith(HasSubstr("inserted_boxes[3]: expected min x <= max x, found 8 > -1")));
  EXPECT_TRUE(fs::is_empty(folder_));
  EXPECT_THAT(Result<Trace>(write_trace(three_bodies_and_two_more(), in_folder("trace.npy"))),
              RefusedWith(HasSubstr("expected a name that ends in .npz")));
  EXPECT_FALSE(write_trace(three_bodies_and_two_more(), in_folder("none/trace.npz")).ok());
}

TEST_F(TraceFile, ThatIsNoArchiveIsRefused) {
  EXPECT_THAT(read_trace(in_folder("none.npz")), RefusedWith(HasSubstr("cannot be read")));
  EXPECT_THAT(read_trace(in_folder("trace.txt")), RefusedWith(HasSubstr("ends in .npz")));
  EXPECT_THAT(parse_npz({}), RefusedWith(HasSubstr("expected a zip archive that is whole")));
  const FileBytes text = FileBytes().text("not an archive, whatever its name says");
  EXPECT_THAT(parse_npz(text.bytes()), RefusedWith(HasSubstr("expected a zip archive that is whole")));
}

/// A .npy as NumPy would write it, of version 1.
std::vector<std::byte> npy(std::string_view type, std::string_view shape, const FileBytes& numbers) {
  std::string dictionary =
      "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': " + std::string(shape) + ", }";
  dictionary.resize(128 - 10 - 1, ' ');
  FileBytes file;
  file.text("\x93NUMPY").byte(1).byte(0).byte(128 - 10).byte(0).text(dictionary).text("\n");
  std::vector<std::byte> bytes(file.bytes().begin(), file.bytes().end());
  bytes.insert(bytes.end(), numbers.bytes().begin(), numbers.bytes().end());
  return bytes;
}

constexpr std::size_t kData = 128;

std::vector<std::byte> longs(std::initializer_list<std::int64_t> numbers) {
  return npy("<i8", "(" + std::to_string(numbers.size()) + ",)", FileBytes().numbers(numbers));
}

struct Member {
  std::string name;
  std::vector<std::byte> bytes;
};

/// The members of the archive that NumPy makes of plain lists, one body that moves in the second frame. Tests
/// put others in their place.
std::vector<Member> members() {
  const FileBytes box = FileBytes().numbers({0.0, 0.0, 0.0, 1.0, 1.0, 1.0});
  return {{"inserted.npy", longs({3})},
          {"inserted_boxes.npy", npy("<f8", "(1, 6)", box)},
          {"inserted_ends.npy", longs({1, 1})},
          {"removed.npy", longs({})},
          {"removed_ends.npy", longs({0, 0})},
          {"moved.npy", longs({3})},
          {"moved_boxes.npy", npy("<f8", "(1, 6)", box)},
          {"moved_ends.npy", longs({0, 1})}};
}

std::vector<std::byte> archive_of(const std::vector<Member>& all) {
  std::vector<ZipMember> zipped;
  for (const Member& member : all)
    zipped.push_back({member.name, std::make_shared<BytesInMemory>(member.bytes)});
  const auto file = std::make_shared<ScratchFile>(fs::path(testing::TempDir()) / "archive.npz");
  EXPECT_TRUE(write_zip(zipped, file).ok());
  std::vector<std::byte> bytes(file->size());
  EXPECT_EQ(file->read_at(0, bytes), static_cast<std::int64_t>(bytes.size()));
  return bytes;
}

Result<Trace> parse(const std::vector<Member>& all) {
  return parse_npz(archive_of(all));
}

/// With one array in the place of that of the name.
Result<Trace> parse_with(std::string_view name, std::vector<std::byte> bytes) {
  std::vector<Member> all = members();
  for (Member& member : all) {
    if (member.name == name) member.bytes = bytes;
  }
  return parse(all);
}

TEST_F(TraceFile, MadeOfPlainListsIsRead) {
  const Result<Trace> trace = parse(members());
  ASSERT_TRUE(trace.ok()) << trace.status().message;
  EXPECT_THAT(trace->inserted, ElementsAre(3));
  EXPECT_EQ(trace->frames(), 2U);
  EXPECT_THAT(trace->moved_ends, ElementsAre(0, 1));
}

TEST_F(TraceFile, ReadsFiltersOfAnyIntegers) {
  std::vector<Member> all = members();
  all.push_back({"category.npy", longs({5})});
  all.push_back({"mask.npy", npy(">u4", "(1,)", FileBytes().number(std::uint32_t{0xfffffffe}, true))});
  all.push_back({"is_static.npy", npy("|b1", "(1,)", FileBytes().byte(1))});
  const Result<Trace> trace = parse(all);
  ASSERT_TRUE(trace.ok()) << trace.status().message;
  EXPECT_THAT(trace->inserted_filters, ElementsAre(BodyFilter{5, 0xfffffffe, true}));
  all.pop_back();
  EXPECT_THAT(parse(all), RefusedWith(HasSubstr("found no is_static")));
  all.push_back({"is_static.npy", longs({2})});
  EXPECT_THAT(parse(all),
              RefusedWith(HasSubstr("is_static.npy, byte 128: expected a number of 0 to 1, found 2")));
  all.back().bytes = longs({0, 0});
  EXPECT_THAT(parse(all), RefusedWith(AllOf(StartsWith("is_static.npy, byte "), HasSubstr("1 elements"))));
}

TEST_F(TraceFile, WithArraysMissingTwiceOrUnknownIsRefused) {
  for (std::size_t i = 0; i < members().size(); ++i) {
    std::vector<Member> all = members();
    const std::string name = all[i].name.substr(0, all[i].name.size() - 4);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_THAT(parse(all), RefusedWith(HasSubstr("found no " + name)));
  }
  std::vector<Member> all = members();
  all.push_back({"catgory.npy", longs({1})});
  EXPECT_THAT(parse(all), RefusedWith(HasSubstr("found \"catgory.npy\"")));
  all.back().name = "moved";
  EXPECT_THAT(parse(all), RefusedWith(HasSubstr("each once, found \"moved\"")));
}

TEST_F(TraceFile, WithArraysOfOtherTypesOrShapesIsRefused) {
  const FileBytes box = FileBytes().numbers({0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F});
  EXPECT_THAT(parse_with("moved.npy", npy("<f4", "(1,)", FileBytes().number(3.0F))),
              RefusedWith(AllOf(StartsWith("moved.npy, byte "), HasSubstr("integers or truth values"))));
  EXPECT_THAT(parse_with("moved_boxes.npy", npy("<i4", "(1, 6)", box)),
              RefusedWith(AllOf(StartsWith("moved_boxes.npy, byte "), HasSubstr("float32 or float64"))));
  EXPECT_THAT(parse_with("moved_boxes.npy", npy("<f4", "(6,)", box)),
              RefusedWith(HasSubstr("expected shape (bodies, 6)")));
  EXPECT_THAT(parse_with("moved.npy", npy("<i8", "(1, 1)", FileBytes().number(std::int64_t{3}))),
              RefusedWith(HasSubstr("expected one dimension")));
  EXPECT_THAT(parse_with("moved.npy", npy("<i8", "(1000000000000000000,)", FileBytes())),
              RefusedWith(HasSubstr("found the end of the array")));
  EXPECT_THAT(parse_with("moved_boxes.npy", npy("<f4", "(768614336404564651, 6)", box)),
              RefusedWith(HasSubstr("found the end of the array")));
  EXPECT_THAT(parse_with("moved.npy", npy("<i8", "()", FileBytes().number(std::int64_t{3}))),
              RefusedWith(HasSubstr("expected one dimension")));
  EXPECT_THAT(
      parse_with("moved.npy", npy("<i8", "(1,)", FileBytes().numbers({std::int64_t{3}, std::int64_t{3}}))),
      RefusedWith(HasSubstr("8 more bytes")));
}

TEST_F(TraceFile, WithNumbersThatNobodyCanHaveIsRefusedWithTheirByte) {
  EXPECT_THAT(
      parse_with("moved.npy", longs({-1})),
      RefusedWith(HasSubstr("moved.npy, byte 128: expected a number of 0 to 4294967295, found a negative")));
  EXPECT_THAT(parse_with("inserted.npy", longs({4'294'967'296})), RefusedWith(HasSubstr("found 4294967296")));
  EXPECT_THAT(parse_with("inserted.npy", longs({1 << 20})),
              RefusedWith(HasSubstr("inserted.npy, byte 128 (frame 0): expected an id below 1048576")));
  const FileBytes wrong = FileBytes().numbers({0.0F, 0.0F, 0.0F, 1.0F, -1.0F, 1.0F});
  EXPECT_THAT(parse_with("moved_boxes.npy", npy("<f4", "(1, 6)", wrong)),
              RefusedWith(HasSubstr("moved_boxes.npy, byte 132: expected min y <= max y, found 0 > -1")));
}

TEST_F(TraceFile, WhoseFramesDoNotHoldTogetherIsRefusedWithTheByte) {
  EXPECT_THAT(parse_with("inserted_ends.npy", longs({})),
              RefusedWith(HasSubstr("expected at least one frame")));
  EXPECT_THAT(parse_with("inserted_ends.npy", longs({1, 0})),
              RefusedWith(HasSubstr("inserted_ends.npy, byte 136 (frame 1): expected the number of bodies")));
  EXPECT_THAT(parse_with("moved_ends.npy", longs({1})), RefusedWith(HasSubstr("expected 2 frames")));
  EXPECT_THAT(
      parse_with("moved_ends.npy", longs({2, 1})),
      RefusedWith(HasSubstr("moved_ends.npy, byte 128 (frame 0): expected a number of 0 to 1, found 2")));
  EXPECT_THAT(
      parse_with("moved_ends.npy", longs({1, 1})),
      RefusedWith(HasSubstr("moved.npy, byte 128 (frame 0): expected a body that was there in the frame "
                            "before, found 3, which is inserted in this frame")));
  EXPECT_THAT(parse_with("moved.npy", longs({4})), RefusedWith(HasSubstr("found 4, which is not there")));
  EXPECT_THAT(parse_with("moved_boxes.npy", npy("<f4", "(0, 6)", FileBytes())),
              RefusedWith(HasSubstr("expected 1 elements, as moved has, found 0")));
}

/// The trace to test with, changed.
std::string refusal_of(const std::function<void(Trace&)>& change) {
  Trace trace = three_bodies_and_two_more();
  change(trace);
  return write_trace(trace, testing::TempDir() + "refused.npz").message;
}

TEST_F(TraceFile, WhoseBodiesComeAndGoWrongIsRefused) {
  EXPECT_THAT(refusal_of([](Trace& trace) { trace.inserted[3] = 1; }), HasSubstr("found 1, which is there"));
  EXPECT_THAT(
      refusal_of([](Trace& trace) { trace.inserted[4] = 2; }),
      HasSubstr("inserted[4] (frame 2): expected a body that is not there, found 2, which is removed"));
  EXPECT_THAT(refusal_of([](Trace& trace) { trace.removed[1] = 0; }),
              HasSubstr("found 0, which is not there"));
  EXPECT_THAT(refusal_of([](Trace& trace) { trace.inserted[1] = 0; }),
              HasSubstr("above the one before it, 0"));
  EXPECT_THAT(refusal_of([](Trace& trace) { trace.inserted_filters.pop_back(); }),
              HasSubstr("expected 5 elements, as inserted has"));
  EXPECT_THAT(refusal_of([](Trace& trace) { trace.inserted_boxes.pop_back(); }),
              HasSubstr("inserted_boxes[4]"));
}

}  // namespace
}  // namespace cellsweep
