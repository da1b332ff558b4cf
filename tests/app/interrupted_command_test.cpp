#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cellsweep/engines.h"
#include "command_line.h"
#include "terminal.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr int kInterrupted = 130;
constexpr int kTerminated = 143;
constexpr const char* kForEver = " --frames 100000000 ";

/// Starts a command, and presses Ctrl-C when its progress shows on the terminal.
class CtrlC : public testing::Test {
 protected:
  int interrupt(const std::string& arguments, const std::string& progress) {
    OnTerminal run(arguments, output_);
    EXPECT_TRUE(run.wait_for(progress)) << run.shown();
    run.press_ctrl_c();
    const int code = run.exit_code();
    EXPECT_THAT(run.shown(), HasSubstr("Stopped by Ctrl-C."));
    shown_ = run.shown();
    return code;
  }

  ScratchFolder scratch_;
  std::string output_ = scratch_.path("output");
  std::string shown_;
};

TEST_F(CtrlC, LeavesTheFramesThatWereSimulated) {
  EXPECT_EQ(
      interrupt(std::string("simulate --bodies 200 --json --engine stream,oracle") + kForEver, "stream: "),
      kInterrupted);
  const Json engines = Json::parse(contents(output_))["engines"];
  ASSERT_EQ(engines.size(), 1U) << "the oracle's turn had not come";
  EXPECT_GT(engines[0]["frames"], 0);
  EXPECT_EQ(engines[0]["reports"].size(), 2U);
  EXPECT_THAT(shown_, HasSubstr("1 more engine was not run"));
}

TEST_F(CtrlC, LeavesTheVerdictsOfTheFramesThatWereCompared) {
  EXPECT_EQ(interrupt(std::string("verify --bodies 100 --engine stream,control") + kForEver, "verify: "),
            kInterrupted);
  EXPECT_THAT(contents(output_), HasSubstr("exact"));
}

TEST_F(CtrlC, LeavesARecordingOfTheFramesUntilThen) {
  const std::string file = scratch_.path("part.npy");
  EXPECT_EQ(interrupt("record --bodies 10 --out " + file + kForEver, "record, frame: "), kInterrupted);
  EXPECT_EQ(run_command("verify --engine stream --frames 5 " + file).exit_code, 0);
}

TEST_F(CtrlC, LeavesAPageOfTheRunsThatWereDone) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no gnuplot";
  const std::string out = scratch_.path("page");
  EXPECT_EQ(interrupt("experiment --bodies 16,32 --out " + out + kForEver, "experiment, frame: "),
            kInterrupted);
  EXPECT_THAT(contents(out + "/report.html"), HasSubstr("Stopped by Ctrl-C when "));
  EXPECT_THAT(contents(output_), HasSubstr("report.html"));
}

TEST_F(CtrlC, LeavesThePicturesThatWereDrawn) {
  if (find_engine("embree") == nullptr) GTEST_SKIP() << "this build makes no pictures";
  const std::string out = scratch_.path("film");
  EXPECT_EQ(
      interrupt("render --bodies 20 --width 16 --height 16 --samples 1 --frames 0:99999999 --out " + out,
                "pictures: "),
      kInterrupted);
  EXPECT_TRUE(std::filesystem::exists(out + "/00000.png"));
}

TEST(Sigterm, LeavesTheFramesThatWereSimulatedAndAWholeTimeline) {
  const ScratchFolder scratch;
  OnTerminal run("simulate --bodies 20 --json --engine stream --trace " + scratch.path("t.json") + kForEver,
                 scratch.path("output"));
  ASSERT_TRUE(run.wait_for("stream: ")) << run.shown();
  EXPECT_FALSE(std::filesystem::exists(scratch.path("t.json"))) << "until it is whole";
  run.terminate();
  EXPECT_EQ(run.exit_code(), kTerminated);
  EXPECT_THAT(run.shown(), HasSubstr("Stopped by SIGTERM."));
  EXPECT_GT(Json::parse(contents(scratch.path("output")))["engines"][0]["frames"], 0);
  EXPECT_FALSE(Json::parse(contents(scratch.path("t.json")))["traceEvents"].empty());
}

TEST(Terminal, ShowsNoProgressOfWhatIsDoneAtOnce) {
  const ScratchFolder scratch;
  OnTerminal run("simulate --engine stream --bodies 10 --frames 1", scratch.path("output"));
  EXPECT_EQ(run.exit_code(), 0);
  EXPECT_EQ(run.shown(), "");
}

}  // namespace
}  // namespace cellsweep::app
