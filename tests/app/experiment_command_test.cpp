#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cellsweep/engines.h"
#include "command_line.h"
#include "project_file.h"

namespace cellsweep::app {
namespace {

using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

bool has_gnuplot() {
  return std::system("gnuplot --version >/dev/null 2>&1") == 0;
}

bool has_pictures() {
  return find_engine("embree") != nullptr;
}

const std::vector<std::string>& figures() {
  static const std::vector<std::string> ids = {"initial", "static", "dynamic-spus", "dynamic",
                                               "dynamic-median"};
  return ids;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// One small experiment, looked at from many sides.
class ExperimentCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
    result_ = run_command("experiment --quick --bodies 32,64 --frames 4 --repetitions 1 --out " + out_);
    ASSERT_EQ(result_.exit_code, 0) << result_.errors;
  }

  ScratchFolder scratch_;
  std::string out_ = scratch_.path("made/on-the-way");
  CommandResult result_;
};

TEST_F(ExperimentCommand, WritesItsFilesAndAPageThatNeedsNothingFromElsewhere) {
  EXPECT_THAT(result_.errors, IsEmpty()) << "progress is for terminals";
  EXPECT_THAT(result_.output, EndsWith(out_ + "/report.html\n"));
  for (const std::string& figure : figures()) {
    EXPECT_THAT(
        contents(out_ + "/" + figure + ".csv"),
        ContainsRegex("\nfigure,curve,engine,part,bodies,median_us,lowest_us,highest_us,repetitions\n" +
                      figure + ",control,control,frame,32,[0-9.e-]+,[0-9.e-]+,[0-9.e-]+,1\n"));
    EXPECT_THAT(contents(out_ + "/" + figure + ".png"), StartsWith("\x89PNG"));
    const std::string svg = contents(out_ + "/" + figure + ".svg");
    EXPECT_THAT(svg, HasSubstr(">boxes in the world<"));
    EXPECT_THAT(
        svg, ContainsRegex(">(time of the first frame|median frame time|longest frame time), logarithmic<"));
    EXPECT_THAT(svg, HasSubstr(">control (x86)<"));
  }
  const std::string page = contents(out_ + "/report.html");
  EXPECT_EQ(count_of(page, "<svg "), figures().size());
  EXPECT_EQ(count_of(page, "<table>"), figures().size());
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(ContainsRegex("(src|href)=.[^#d]"))) << "data URIs and places in the page only";
  EXPECT_THAT(page, ContainsRegex(" boxes, with control[a-z, -]* stream[a-z, -]* of cellsweep, on one"));
  EXPECT_THAT(page, HasSubstr("holds here"));
  EXPECT_THAT(page, HasSubstr("cannot be judged here")) << "with 1,024 boxes nothing was measured";
  for (const std::string name : {"cpu", "compiler", "flags", "commit", "seed"}) {
    EXPECT_THAT(page, HasSubstr("<dt>" + name + "</dt>"));
  }
  EXPECT_EQ(page.find("data:image/png;base64,iVBORw0KGgo") != std::string::npos, has_pictures());
}

TEST(ExperimentCommandWithoutGnuplot, SaysWhatToInstallBeforeItMeasures) {
  const std::string command = CELLSWEEP_COMMAND;
  if (command.find(' ') != std::string::npos) GTEST_SKIP() << "the emulator would not be found either";
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("experiment --out " + scratch.path("out"), "PATH=" + scratch.path("empty"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("gnuplot-nox"));
  EXPECT_THAT(result.output, IsEmpty());
}

TEST(ExperimentCommandFolder, IsForOneAtATime) {
  if (!has_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  const ScratchFolder scratch;
  const std::string out = scratch.path("out");
  std::filesystem::create_directory(out);
  const int other = open(out.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  const CommandResult result = run_command("experiment --quick --bodies 32 --frames 1 --out " + out);
  close(other);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr(out + ": another cellsweep writes there now"));
  EXPECT_TRUE(std::filesystem::is_empty(out));
}

TEST(ExperimentCommandSettings, AreRefusedInWords) {
  if (!has_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  const ScratchFolder scratch;
  const std::string out = " --out " + scratch.path("out");
  EXPECT_EQ(run_command("experiment").exit_code, 2);
  for (const std::string setting : {"--bodies 0", "--frames 0", "--repetitions 0", "--bodies 64,many"}) {
    const CommandResult result = run_command("experiment " + setting + out);
    EXPECT_EQ(result.exit_code, 2) << setting;
    EXPECT_THAT(result.errors, Not(IsEmpty())) << setting;
  }
}

class RenderCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_pictures()) GTEST_SKIP() << "this build makes no pictures";
  }

  ScratchFolder scratch_;
};

const std::string kSmallPicture = " --width 48 --height 32 --samples 2 --bodies 60";

TEST_F(RenderCommand, DrawsAFrameOfASceneTheSameEachTime) {
  for (const std::string file : {"one.png", "other.png"}) {
    const CommandResult result = run_command("render --frame 3 --out " + scratch_.path(file) + kSmallPicture);
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.output + result.errors, IsEmpty());
  }
  EXPECT_THAT(contents(scratch_.path("one.png")), StartsWith("\x89PNG"));
  EXPECT_EQ(contents(scratch_.path("one.png")), contents(scratch_.path("other.png")));
}

TEST_F(RenderCommand, DrawsASequenceWhosePicturesAreThoseOfItsFrames) {
  ASSERT_EQ(
      run_command("render --frames 2:4 --moving 1 --out " + scratch_.path("film") + kSmallPicture).exit_code,
      0);
  ASSERT_EQ(
      run_command("render --frame 3 --moving 1 --out " + scratch_.path("3.png") + kSmallPicture).exit_code,
      0);
  EXPECT_EQ(contents(scratch_.path("film/00003.png")), contents(scratch_.path("3.png")));
  EXPECT_NE(contents(scratch_.path("film/00004.png")), contents(scratch_.path("3.png")));
  EXPECT_THAT(contents(scratch_.path("film/00002.png")), Not(IsEmpty()));
  EXPECT_THAT(contents(scratch_.path("film/00001.png")), IsEmpty());
}

TEST_F(RenderCommand, DrawsTheBodiesThatAreThere) {
  const std::string open_world = "render --scene open-world --out " + scratch_.path("at.png") + kSmallPicture;
  ASSERT_EQ(run_command(open_world + " --frame 0").exit_code, 0);
  const std::string whole = contents(scratch_.path("at.png"));
  ASSERT_EQ(run_command(open_world + " --frame 8").exit_code, 0);
  EXPECT_NE(contents(scratch_.path("at.png")), whole);
}

TEST_F(RenderCommand, DrawsRecordings) {
  const CommandResult result =
      run_command("render " + project_file("bench/scenes/bullet-pile-1024.aabbs") +
                  " --frame 30 --width 48 --height 32 --samples 1 --out " + scratch_.path("pile.png"));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
}

TEST_F(RenderCommand, RefusesWhatItCannotDraw) {
  const std::string pile = project_file("bench/scenes/bullet-pile-1024.aabbs");
  const std::string out = " --out " + scratch_.path("a.png");
  const CommandResult late = run_command("render " + pile + " --frame 31" + out);
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.errors, HasSubstr("the last frame is 30"));
  EXPECT_EQ(run_command("render --width 0" + out).exit_code, 2);
  EXPECT_EQ(run_command("render --frames 5:4" + out).exit_code, 2);
  EXPECT_EQ(run_command("render --frames five" + out).exit_code, 2);
  EXPECT_EQ(run_command("render --frame 1 --frames 1:2" + out).exit_code, 2);
  const std::string cuts = scratch_.path("cuts.json");
  for (const std::string words :
       {"", "{}", R"({"ranks": []})", R"({"ranks": [{"region": [[0, 1], [2, 3]]}]})",
        R"({"ranks": [{"region": [["a", 0, 0], [1, 1, 1]]}]})"}) {
    std::ofstream(cuts) << words;
    const CommandResult result = run_command("render --cuts " + cuts + out);
    EXPECT_EQ(result.exit_code, 2) << words;
    EXPECT_THAT(result.errors,
                HasSubstr("--cuts " + cuts + ": It is not what cellsweep-ranks --json prints"));
  }
  EXPECT_EQ(run_command("render --cuts /no/such/file" + out).exit_code, 2);
  EXPECT_EQ(run_command("render --bodies 3 --out /no/such/folder/a.png --width 8 --height 8").exit_code, 2);
}

}  // namespace
}  // namespace cellsweep::app
