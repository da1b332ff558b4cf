/// @file
/// Allocations of the command fail, one after the other: it says so and ends with the code for that, whatever
/// it was at.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <string>

#include "base/text.h"
#include "cellsweep/world/trace.h"
#include "failing_calls.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;

constexpr int kNoMemory = 7;

/// All of them where somebody asks for it, which takes minutes; otherwise the first few, and then some.
long step_after(long number, long step) {
  static const bool all = std::getenv("CELLSWEEP_EVERY_ALLOCATION") != nullptr;
  return all || number < 20 ? 1 : step;
}

class WantOfMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_fail_calls()) GTEST_SKIP() << "no calls can be made to fail in this build";
  }

  /// An allocation that fails once may be one that can be done without; when all fail from one on, hardly.
  static void fail_from(long first, long step, const std::string& arguments) {
    ASSERT_EQ(run_command(arguments).exit_code, 0) << arguments;
    const long calls = calls_of("malloc", arguments);
    ASSERT_GT(calls, first);
    for (const bool and_later : {false, true}) {
      for (long number = first; number <= calls; number += step_after(number - first, step)) {
        const CommandResult result =
            run_failing(arguments, {"malloc", number, std::to_string(ENOMEM), and_later});
        if (result.exit_code == 0) continue;
        EXPECT_EQ(result.exit_code, kNoMemory)
            << arguments << ": " << number << " of " << calls << (and_later ? " and later" : "") << '\n'
            << result.errors;
        EXPECT_THAT(result.errors, HasSubstr("no more memory"));
      }
    }
  }

  ScratchFolder scratch_;
};

TEST_F(WantOfMemory, EndsTheCommandInWordsAtItsStart) {
  fail_from(1, 197, "--version");
}

TEST_F(WantOfMemory, EndsARunInWords) {
  const std::string run = "simulate --bodies 20 --frames 3 --engine stream,control,oracle --trace ";
  fail_from(calls_of("malloc", "--version"), 23, run + scratch_.path("timeline.json"));
}

TEST_F(WantOfMemory, EndsWhatReadsAndWritesInWords) {
  if (!traces_have_files()) GTEST_SKIP() << "a build without libzip";
  const std::string file = scratch_.path("a.npz");
  const long start = calls_of("malloc", "--version");
  fail_from(start, 11, "record --bodies 20 --frames 3 --out " + file);
  ASSERT_EQ(run_command("record --bodies 20 --frames 3 --out " + file).exit_code, 0);
  fail_from(start, 17, "verify " + file + " --engine stream");
}

TEST_F(WantOfMemory, OfPagesIsSaidToo) {
  const std::string run = "simulate --bodies 3000 --frames 2 --engine stream --threads 2";
  const long calls = calls_of("mmap", run);
  for (long number = 1; number <= calls; ++number) {
    const CommandResult result = run_failing(run, {"mmap", number, std::to_string(ENOMEM)});
    EXPECT_THAT(result.exit_code, ::testing::AnyOf(0, kNoMemory)) << number << '\n' << result.errors;
  }
}

TEST(MoreThanAllMemory, IsNotBadUsage) {
#if defined(CELLSWEEP_SANITIZED_TESTS) || defined(CELLSWEEP_EMULATED_TESTS)
  GTEST_SKIP() << "a sanitizer, and an emulator, needs the addresses for itself";
#endif
  const CommandResult result =
      run_command("simulate --bodies 4000000 --frames 1 --engine stream", "ulimit -v 300000;");
  EXPECT_EQ(result.exit_code, kNoMemory);
  EXPECT_THAT(result.errors, HasSubstr("no more memory"));
}

}  // namespace
}  // namespace cellsweep::app
