#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/text.h"
#include "command_line.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;

constexpr const char* kRun = "simulate --bodies 20 --frames 2 --engine stream";

/// A command line of the shell with CELLSWEEP in it, and what it says on standard error.
CommandResult run_line(std::string line) {
  const ScratchFolder scratch;
  const std::string name = "CELLSWEEP";
  for (std::size_t at = line.find(name); at != std::string::npos; at = line.find(name))
    line.replace(at, name.size(), CELLSWEEP_COMMAND);
  const int status = std::system(text("( ", line, " ) 2>", scratch.path("errors")).c_str());
  std::ifstream file(scratch.path("errors"));
  std::ostringstream errors;
  errors << file.rdbuf();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", errors.str()};
}

TEST(LostOutput, OfAFullDiskIsAnError) {
  for (const std::string& arguments :
       {std::string(kRun), std::string(kRun) + " --json", std::string("engines"),
        std::string("query --point 0,0,0"), std::string("query --point 0,0,0 --json"), std::string("--help"),
        std::string("--version")}) {
    const CommandResult result = run_line("CELLSWEEP " + arguments + " >/dev/full");
    EXPECT_EQ(result.exit_code, kOutputLost) << arguments;
    EXPECT_THAT(result.errors, HasSubstr("Standard output cannot be written: No space left on device."));
  }
}

TEST(LostOutput, OfATimelineIsAnError) {
  const CommandResult result = run_line(text("CELLSWEEP ", kRun, " --trace /dev/full >/dev/null"));
  EXPECT_EQ(result.exit_code, kOutputLost);
  EXPECT_THAT(result.errors, HasSubstr("/dev/full: cannot be written: No space left on device."));
}

TEST(LostOutput, ToAPipeThatNobodyReadsIsAnError) {
  // The other side is closed before the command begins.
  const CommandResult result = run_line(text("{ sleep 0.2; CELLSWEEP ", kRun, "; echo $? >&2; } | true"));
  EXPECT_THAT(result.errors, HasSubstr("Standard output cannot be written: Broken pipe."));
  EXPECT_THAT(result.errors, HasSubstr("\n6\n"));
}

TEST(LostOutput, WithoutAnyStandardOutputIsAnErrorAndNoFileTakesItsPlace) {
  const ScratchFolder scratch;
  const std::string file = scratch.path("a.npy");
  EXPECT_EQ(run_line("CELLSWEEP record --bodies 2 --frames 1 --out " + file + " >&-").exit_code, kOutputLost);
  EXPECT_EQ(std::filesystem::file_size(file), 128U + 2 * 2 * 24);
}

TEST(LostOutput, DoesNotHideThatResultsDiffer) {
  const CommandResult result = run_line(
      "CELLSWEEP verify --scene varied --bodies 400 --moving 1 --engine control --literal >/dev/full");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("Standard output cannot be written"));
}

}  // namespace
}  // namespace cellsweep::app
