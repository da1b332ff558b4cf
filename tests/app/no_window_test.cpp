#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command_line.h"

namespace cellsweep::app {
namespace {

TEST(ViewInABuildWithoutWindows, SaysWhatTheBuildWants) {
  const CommandResult result = run_command("view --bodies 20");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, testing::HasSubstr("libglfw3-dev"));
}

}  // namespace
}  // namespace cellsweep::app
