#include "cellsweep/engine/new_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class NewFileTest : public testing::Test {
 protected:
  NewFileTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    return all;
  }

  std::string contents(const std::string& name) const {
    std::ifstream file(in_folder(name));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_ = fs::path(testing::TempDir()) / "cellsweep-new-files" /
                     testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(NewFileTest, IsThereWhenItIsCommittedAndNotBefore) {
  NewFile file;
  ASSERT_TRUE(file.open(in_folder("a")).ok());
  ASSERT_TRUE(file.write("one ").ok());
  ASSERT_TRUE(file.write("two").ok());
  EXPECT_FALSE(fs::exists(in_folder("a")));
  ASSERT_TRUE(file.commit().ok());
  EXPECT_EQ(contents("a"), "one two");
  EXPECT_THAT(names(), ElementsAre("a"));
}

TEST_F(NewFileTest, ThatIsNotCommittedLeavesWhatWasThere) {
  ASSERT_TRUE(write_new_file(in_folder("a"), "old").ok());
  {
    NewFile file;
    ASSERT_TRUE(file.open(in_folder("a")).ok());
    ASSERT_TRUE(file.write("new").ok());
  }
  EXPECT_EQ(contents("a"), "old");
  EXPECT_THAT(names(), ElementsAre("a"));
}

TEST_F(NewFileTest, KeepsOwnerAndModeOfTheFileThatItReplaces) {
  ASSERT_TRUE(write_new_file(in_folder("a"), "old").ok());
  ASSERT_EQ(chmod(in_folder("a").c_str(), 0640), 0);
  const bool is_root = geteuid() == 0;
  ASSERT_EQ(chown(in_folder("a").c_str(), is_root ? 1234 : geteuid(), is_root ? 4321 : getegid()), 0);
  ASSERT_TRUE(write_new_file(in_folder("a"), "new").ok());
  struct stat now {};
  ASSERT_EQ(stat(in_folder("a").c_str(), &now), 0);
  EXPECT_EQ(contents("a"), "new");
  EXPECT_EQ(now.st_mode & 07777, 0640U);
  EXPECT_EQ(now.st_uid, is_root ? 1234U : geteuid());
  EXPECT_EQ(now.st_gid, is_root ? 4321U : getegid());
}

TEST_F(NewFileTest, HasTheModeThatTheUmaskLeaves) {
  const mode_t before = umask(027);
  const Status status = write_new_file(in_folder("a"), "new");
  umask(before);
  ASSERT_TRUE(status.ok());
  struct stat now {};
  ASSERT_EQ(stat(in_folder("a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, 0640U);
}

TEST_F(NewFileTest, InThePlaceOfAReadOnlyOneIsRefusedFromRootToo) {
  ASSERT_TRUE(write_new_file(in_folder("a"), "old").ok());
  ASSERT_EQ(chmod(in_folder("a").c_str(), 0444), 0);
  const Status status = write_new_file(in_folder("a"), "new");
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.message, in_folder("a") + ": cannot be written: it is read-only, and stays as it is.");
  EXPECT_EQ(contents("a"), "old");
}

TEST_F(NewFileTest, GoesWhereALinkLeadsAndTheLinkStays) {
  ASSERT_TRUE(write_new_file(in_folder("a"), "old").ok());
  fs::create_symlink("a", in_folder("link"));
  ASSERT_TRUE(write_new_file(in_folder("link"), "new").ok());
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(contents("a"), "new");
}

TEST_F(NewFileTest, InThePlaceOfAFolderOrBesideNothingIsRefused) {
  for (const std::string& path : {folder_.string(), in_folder("none/a"), std::string()}) {
    const Status status = write_new_file(path, "new");
    EXPECT_EQ(status.code, StatusCode::bad_input) << path;
    EXPECT_THAT(status.message, HasSubstr(path.empty() ? "\"\": cannot" : path + ": cannot be written: "));
  }
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(NewFileTest, ToADeviceGoesThereAndTheDeviceStays) {
  EXPECT_TRUE(write_new_file("/dev/null", "anything").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Status status = write_new_file("/dev/full", "anything");
  EXPECT_EQ(status.code, StatusCode::write_failed);
  EXPECT_THAT(status.message, HasSubstr("No space left on device"));
}

TEST_F(NewFileTest, TakesAwayWhatAKilledWriterLeft) {
  std::ofstream(in_folder(".cellsweep-0.tmp")) << "half of";
  std::ofstream(in_folder(".cellsweep-1.tmp")) << "half of another";
  ASSERT_TRUE(write_new_file(in_folder("a"), "new").ok());
  EXPECT_THAT(names(), ElementsAre("a"));
}

TEST_F(NewFileTest, LeavesAloneWhatAnotherWriterIsAt) {
  std::ofstream(in_folder(".cellsweep-0.tmp")) << "nearly whole";
  const int other = open(in_folder(".cellsweep-0.tmp").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  ASSERT_TRUE(write_new_file(in_folder("a"), "old").ok());
  ASSERT_TRUE(write_new_file(in_folder("a"), "new").ok());
  EXPECT_EQ(contents("a"), "new");
  EXPECT_THAT(names(), UnorderedElementsAre(".cellsweep-0.tmp", "a"));
  close(other);
}

}  // namespace
}  // namespace cellsweep
