/// @file
/// Every command that writes a file, with each system call that it makes on the way failing, and killed
/// before each: under the file's name is what was there or the whole new file, and nothing is left beside it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "cellsweep/world/trace.h"
#include "command_line.h"
#include "failing_calls.h"

namespace cellsweep::app {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr const char* kOld = "what was there before";

/// A command that writes one file, whose name comes last.
struct Writer {
  std::string name;
  std::string arguments;
  std::string file;
  bool same_each_time = true;
};

void PrintTo(const Writer& writer, std::ostream* stream) {
  *stream << writer.arguments;
}

class WrittenFile : public testing::TestWithParam<Writer> {
 protected:
  void SetUp() override {
    if (!can_fail_calls()) GTEST_SKIP() << "no calls can be made to fail in this build";
    if (GetParam().file == "a.png" && find_engine("embree") == nullptr)
      GTEST_SKIP() << "this build makes no pictures";
    if (GetParam().file == "a.npz" && !traces_have_files()) GTEST_SKIP() << "a build without libzip";
    fs::create_directories(path().parent_path());
    ASSERT_EQ(run_command(arguments()).exit_code, 0);
    whole_ = contents(path());
  }

  fs::path path() const { return scratch_.path("folder/" + GetParam().file); }
  std::string arguments() const { return GetParam().arguments + " " + path().string(); }

  void set_before(bool is_there) const {
    fs::remove_all(path().parent_path());
    fs::create_directories(path().parent_path());
    if (is_there) std::ofstream(path()) << kOld;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(path().parent_path()))
      all.push_back(entry.path().filename().string());
    return all;
  }

  /// Ctrl-C ends a recording with the frames until then; of those the file is whole.
  bool is_ended_early() const {
    return arguments().starts_with("record ") && contents(path()) != kOld &&
           run_command("replay " + path().string() + " --engine control").exit_code == 0;
  }

  /// A timeline has other times in each run; that it is whole shows at its end.
  bool is_whole() const {
    const std::string now = contents(path());
    return GetParam().same_each_time ? now == whole_ : now.ends_with("]}\n");
  }

  bool is_as_before(bool was_there) const {
    return was_there ? contents(path()) == kOld : !fs::exists(path());
  }

  void expect_old_or_new(bool was_there, const std::string& when) const {
    EXPECT_TRUE(is_as_before(was_there) || is_whole()) << when;
  }

  void fail_all(const std::string& kind, const std::string& what, bool was_there) const {
    set_before(was_there);
    const long calls = calls_of(kind, arguments());
    for (long number = 1; number <= calls; ++number) {
      const std::string when = text(kind, " ", number, " of ", calls, ": ", what);
      set_before(was_there);
      const CommandResult result = run_failing(arguments(), {kind, number, what});
      if (result.exit_code == 0) {
        EXPECT_TRUE(is_whole()) << when;
      } else {
        EXPECT_THAT(result.exit_code, AnyOf(2, kOutputLost)) << when << '\n' << result.errors;
        EXPECT_THAT(result.errors, HasSubstr(path().string())) << when;
        expect_old_or_new(was_there, when);
      }
      for (const std::string& name : names()) EXPECT_EQ(name, GetParam().file) << when;
    }
  }

  ScratchFolder scratch_;
  std::string whole_;
};

TEST_P(WrittenFile, IsTheOldOrTheNewOneWhateverCallFails) {
  for (const bool was_there : {false, true}) {
    for (const std::string kind : {"open", "write", "fsync", "fchmod", "link", "rename", "close"}) {
      for (const int error : {EIO, ENOSPC}) fail_all(kind, std::to_string(error), was_there);
    }
  }
}

TEST_P(WrittenFile, IsWholeWhenWritesAreShort) {
  fail_all("write", "short", true);
}

TEST_P(WrittenFile, OfAFullDiskIsAnErrorOfItsOwn) {
  set_before(true);
  const CommandResult result = run_failing(arguments(), {"write", 1, std::to_string(ENOSPC), true});
  EXPECT_EQ(result.exit_code, kOutputLost);
  EXPECT_THAT(result.errors, HasSubstr(": cannot be written: No space left on device."));
  EXPECT_TRUE(is_as_before(true));
}

TEST_P(WrittenFile, IsTheOldOrTheNewOneWhenTheCommandIsKilledBeforeAnyCall) {
  for (const bool was_there : {false, true}) {
    set_before(was_there);
    const long calls = calls_of("file", arguments());
    EXPECT_GE(calls, was_there ? 5 : 4);
    for (long number = 1; number <= calls; ++number) {
      const std::string when = text("before call ", number, " of ", calls);
      set_before(was_there);
      EXPECT_EQ(run_failing(arguments(), {"file", number, "signal-9"}).exit_code, 128 + 9) << when;
      expect_old_or_new(was_there, when);
      EXPECT_EQ(run_command(arguments()).exit_code, 0);
      EXPECT_TRUE(is_whole());
      EXPECT_THAT(names(), ElementsAre(GetParam().file)) << "what was left goes when the next one writes";
    }
  }
}

TEST_P(WrittenFile, LeavesNothingBesideItWhenASignalEndsTheCommand) {
  for (const std::string signal : {"signal-2", "signal-15"}) {
    set_before(true);
    const long calls = calls_of("file", arguments());
    for (long number = 1; number <= calls; ++number) {
      set_before(true);
      run_failing(arguments(), {"file", number, signal});
      if (!is_ended_early()) expect_old_or_new(true, text(signal, " before call ", number));
      EXPECT_THAT(names(), ElementsAre(GetParam().file)) << signal << " before call " << number;
    }
  }
}

TEST(ReadFile, IsRefusedInWordsWhicheverReadFails) {
  if (!can_fail_calls()) GTEST_SKIP() << "no calls can be made to fail in this build";
  const ScratchFolder scratch;
  for (const std::string name : {"a.aabbs", "a.npy", "a.npz"}) {
    if (name == "a.npz" && !traces_have_files()) continue;
    ASSERT_EQ(run_command("record --bodies 20 --frames 6 --out " + scratch.path(name)).exit_code, 0);
    const std::string replay = "replay " + scratch.path(name) + " --engine stream,control";
    for (const std::string kind : {"open", "read"}) {
      const long calls = calls_of(kind, replay);
      EXPECT_GT(calls, 0) << name;
      for (long number = 1; number <= calls; ++number) {
        const CommandResult result = run_failing(replay, {kind, number, std::to_string(EIO)});
        EXPECT_EQ(result.exit_code, 2) << name << ": " << kind << ' ' << number;
        EXPECT_THAT(result.errors, HasSubstr(scratch.path(name) + ": ")) << kind << ' ' << number;
        EXPECT_EQ(result.output, "") << kind << ' ' << number;
        EXPECT_EQ(run_failing(replay, {"read", number, "short"}).exit_code, 0) << number;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, WrittenFile,
    testing::Values(
        Writer{"RecordingOfBroadmark", "record --bodies 20 --frames 3 --out", "a.aabbs"},
        Writer{"RecordingOfNumPy", "record --bodies 20 --frames 3 --out", "a.npy"},
        Writer{"Trace", "record --bodies 20 --frames 3 --out", "a.npz"},
        Writer{"LongTrace", "record --bodies 150 --moving 1 --frames 40 --out", "a.npz"},
        Writer{"Timeline", "simulate --bodies 20 --frames 3 --engine stream --trace", "t.json", false},
        Writer{"Picture", "render --bodies 9 --width 8 --height 8 --samples 1 --threads 1 --out", "a.png"}),
    [](const auto& writer) { return writer.param.name; });

}  // namespace
}  // namespace cellsweep::app
