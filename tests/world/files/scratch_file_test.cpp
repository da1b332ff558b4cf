/// @file
/// Files without a name: what is in them comes back, nobody sees them, and a full disk is said.
#include "world/files/scratch_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using ::testing::StartsWith;

/// Each test in an empty folder of its own.
class ScratchFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path("scratch-file") / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  fs::path folder_;
};

std::vector<std::byte> counted(std::size_t size) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i % 251);
  return bytes;
}

std::vector<std::byte> all_of(const ByteSource& source) {
  std::vector<std::byte> bytes(source.size());
  EXPECT_EQ(source.read_at(0, bytes), static_cast<std::int64_t>(bytes.size()));
  return bytes;
}

TEST_F(ScratchFileTest, HoldsWhatIsAppendedInSmallPartsAndInLargeOnes) {
  ScratchFile file(folder_ / "a");
  const auto bytes = counted(300'000);
  for (std::size_t begin = 0, size = 1; begin < bytes.size(); begin += size, size = size * 3 + 1)
    ASSERT_TRUE(file.append(std::span(bytes).subspan(begin, std::min(size, bytes.size() - begin))).ok());
  ASSERT_TRUE(file.flush().ok());
  EXPECT_EQ(all_of(file), bytes);
}

TEST_F(ScratchFileTest, HasNoName) {
  ScratchFile file(folder_ / "a");
  ASSERT_TRUE(file.append(counted(100'000)).ok());
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(ScratchFileTest, OfADeviceIsElsewhere) {
  ScratchFile file("/dev/null");
  ASSERT_TRUE(file.append(counted(100'000)).ok());
  ASSERT_TRUE(file.flush().ok());
  EXPECT_EQ(all_of(file), counted(100'000));
}

TEST_F(ScratchFileTest, OfFewBytesNeedsNoDisk) {
  ScratchFile file("no/such/folder/a");
  ASSERT_TRUE(file.append(counted(10)).ok());
  ASSERT_TRUE(file.flush().ok());
  EXPECT_EQ(all_of(file), counted(10));
  EXPECT_EQ(file.append(counted(100'000)).code, StatusCode::write_failed);
  EXPECT_THAT(file.status().message, StartsWith("no/such/folder/a: cannot be written: "));
}

TEST_F(ScratchFileTest, IsWrittenAnywhereUpToItsEnd) {
  for (const std::size_t size : {1'000, 60'000, 70'000, 200'000}) {
    ScratchFile file(folder_ / "a");
    auto bytes = counted(size);
    ASSERT_TRUE(file.write_at(0, std::vector<std::byte>(30)));
    ASSERT_TRUE(file.write_at(30, std::span(bytes).subspan(30)));
    ASSERT_TRUE(file.write_at(0, std::span(bytes).first(30)));
    EXPECT_EQ(all_of(file), bytes) << size;
  }
}

TEST_F(ScratchFileTest, SaysThatTheDiskIsFullAndGoesOnSayingIt) {
  ScratchFile file(folder_ / "a");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{1'000, before.rlim_max};
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &limit);
  const Status appended = file.append(counted(100'000));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(appended.code, StatusCode::write_failed);
  EXPECT_THAT(appended.message, StartsWith((folder_ / "a").string() + ": cannot be written: "));
  EXPECT_EQ(file.flush().code, StatusCode::write_failed);
}

TEST(HeadedBytes, AreTheHeadAndThenTheBody) {
  const auto body = counted(10);
  const HeadedBytes bytes(counted(3), std::make_shared<BytesInMemory>(body));
  ASSERT_EQ(bytes.size(), 13U);
  std::vector<std::byte> part(20);
  EXPECT_EQ(bytes.read_at(0, part), 3) << "a part of what was asked for";
  EXPECT_EQ(bytes.read_at(3, part), 10);
  EXPECT_EQ(part[9], body[9]);
  EXPECT_EQ(bytes.read_at(12, part), 1);
  EXPECT_EQ(bytes.read_at(13, part), 0);
}

}  // namespace
}  // namespace cellsweep
