#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cellsweep/engines.h"
#include "cellsweep/world/scene.h"
#include "command_line.h"
#include "project_file.h"

namespace cellsweep::app {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

const std::string kPile = project_file("bench/scenes/bullet-pile-1024.aabbs");

TEST(Command, ReplaysTheRecordedPileWithItsKnownPairs) {
  const CommandResult result =
      run_command("replay " + kPile + " --engine control --json --report-frames 0,15,30");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const Json engine = Json::parse(result.output)["engines"][0];
  EXPECT_EQ(engine["engine"], "control");
  EXPECT_EQ(engine["bodies"], 1024);
  EXPECT_EQ(engine["frames"], 30);
  EXPECT_EQ(engine["reports"].size(), 3U);
  EXPECT_EQ(engine["reports"][0], Json::parse(R"({"frame":0,"pairs":5577,"hash":"875cb2208a071dd3"})"));
  EXPECT_GT(engine["initial_ms"], 0.0);
  EXPECT_LE(engine["update_ms"]["median"], engine["update_ms"]["p99"]);
  EXPECT_LE(engine["update_ms"]["p99"], engine["update_ms"]["max"]);
}

TEST(Command, SimulatesASceneWithEveryEngineByDefault) {
  const CommandResult result = run_command("simulate --scene varied --bodies 60 --frames 5 --json");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(Json::parse(result.output)["engines"].size(), engine_table().size());
}

TEST(Command, GivesTheSameHashesForTheSameSeedAndOthersForAnother) {
  const auto reports = [](const std::string& seed) {
    const CommandResult result =
        run_command("simulate --bodies 300 --frames 3 --json --engine control --seed " + seed);
    return Json::parse(result.output)["engines"][0]["reports"];
  };
  EXPECT_EQ(reports("7"), reports("7"));
  EXPECT_NE(reports("7"), reports("8"));
}

TEST(Command, PrintsTablesForAPerson) {
  const CommandResult result = run_command("simulate --bodies 64 --frames 2 --engine control");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("engine"));
  EXPECT_THAT(result.output, HasSubstr("control"));
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST(Command, VerifiesEnginesAgainstTheOracle) {
  const CommandResult result =
      run_command("verify --scene wall --bodies 200 --moving 1 --spinning --frames 20");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("exact"));
}

TEST(Command, VerifiesEnginesWhereNotAllBodiesMeet) {
  for (const std::string scene : {"level", "pile", "open-world"}) {
    const std::string run = "verify --bodies 150 --frames 20 --json --scene " + scene;
    const CommandResult all = run_command(run);
    const CommandResult some = run_command(run + " --static --groups 2");
    EXPECT_EQ(some.exit_code, 0) << some.errors;
    EXPECT_NE(some.output, all.output) << "fewer pairs";
  }
  EXPECT_EQ(
      run_command("verify --engine cell-resident --spu-boxes --static --bodies 100 --frames 5").exit_code, 0);
  EXPECT_THAT(run_command("simulate --groups 33").errors, HasSubstr("--groups"));
}

TEST(Command, ComparesTheOracleWithItselfOnlyWhereItIsAskedTo) {
  const std::string run = "verify --bodies 50 --frames 2 --json";
  const CommandResult all = run_command(run);
  EXPECT_EQ(all.exit_code, 0) << all.errors;
  EXPECT_THAT(all.errors, IsEmpty());
  EXPECT_THAT(all.output, AllOf(HasSubstr("\"stream\""), Not(HasSubstr("\"oracle\""))));
  EXPECT_THAT(run_command(run + " --engine oracle").output, HasSubstr("\"oracle\""));
}

TEST(Command, ExitsWithOneAndShowsThePairWhenAnEngineIsNotExact) {
  const std::string arguments = "verify --scene varied --bodies 400 --moving 1 --engine control --literal";
  const CommandResult table = run_command(arguments);
  EXPECT_EQ(table.exit_code, 1);
  EXPECT_THAT(table.output, HasSubstr("overlaps but was not reported"));
  const CommandResult json = run_command(arguments + " --json");
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_EQ(Json::parse(json.output)["exact"], false);
}

TEST(Command, RecordsASceneThatReplaysToTheSamePairs) {
  const ScratchFolder scratch;
  const std::string scene = " --scene clustered --bodies 150 --frames 10";
  const Json simulated = Json::parse(run_command("simulate --json --engine control" + scene).output);
  for (const std::string file : {"scene.aabbs", "scene.npy"}) {
    ASSERT_EQ(run_command("record --out " + scratch.path(file) + scene).exit_code, 0);
    const CommandResult replayed = run_command("replay --json --engine control " + scratch.path(file));
    ASSERT_EQ(replayed.exit_code, 0) << replayed.errors;
    EXPECT_EQ(Json::parse(replayed.output)["engines"][0]["reports"], simulated["engines"][0]["reports"]);
  }
}

TEST(Command, RunsAndVerifiesAWorldWhoseBodiesComeAndGo) {
  const std::string scene = " --scene open-world --bodies 600 --frames 40 --json";
  const CommandResult verified = run_command("verify" + scene);
  ASSERT_EQ(verified.exit_code, 0) << verified.errors;
  const CommandResult simulated = run_command("simulate --report-frames 8,16,40" + scene);
  ASSERT_EQ(simulated.exit_code, 0) << simulated.errors;
  const Json engines = Json::parse(simulated.output)["engines"];
  for (const Json& engine : engines) EXPECT_EQ(engine["reports"], engines[0]["reports"]);
  EXPECT_LT(engines[0]["reports"][0]["pairs"], engines[0]["reports"][1]["pairs"]) << "8 of 64 batches went";
}

TEST(Command, VerifiesEverySceneWithAGiantInEachPlace) {
  for (const SceneInfo& scene : scene_table()) {
    for (const std::string slot : {"first", "middle", "last"}) {
      const CommandResult result =
          run_command("verify --engine stream,control --bodies 120 --frames 12 --giant " + slot +
                      " --scene " + std::string(scene.name));
      EXPECT_EQ(result.exit_code, 0) << scene.name << ' ' << slot << '\n' << result.output << result.errors;
    }
  }
}

TEST(Command, ConvertsARecording) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_command("record --from " + kPile + " --out " + scratch.path("pile.npy")).exit_code, 0);
  const CommandResult result = run_command("replay --json --frames 0 " + scratch.path("pile.npy"));
  EXPECT_EQ(Json::parse(result.output)["engines"][0]["reports"][0]["hash"], "875cb2208a071dd3");
}

TEST(Command, ListsTheEnginesWithWhatTheyHold) {
  const CommandResult result = run_command("engines --json");
  ASSERT_EQ(result.exit_code, 0);
  const Json control = Json::parse(result.output)["engines"][0];
  EXPECT_EQ(control["engine"], "control");
  EXPECT_EQ(control["max_bodies"], 4096);
  EXPECT_EQ(control["raise"], "--pair-map-bytes");
  EXPECT_THAT(control["flags"], Contains("--literal"));
}

TEST(Command, DemonstratesEveryEngineVerified) {
#ifdef CELLSWEEP_SANITIZED_TESTS
  const std::string frames = "3";  // of some engines one takes seconds
#else
  const std::string frames = "20";
#endif
  const CommandResult result = run_command("demo --frames " + frames + " " + kPile);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  for (const EngineInfo& info : engine_table()) EXPECT_THAT(result.output, HasSubstr(std::string(info.name)));
  EXPECT_THAT(result.output, HasSubstr("bullet-pile"));
  EXPECT_THAT(result.output, HasSubstr("paper"));
  EXPECT_THAT(result.output, Not(HasSubstr("differs")));
}

struct Refusal {
  std::string name;
  std::string arguments;
  int exit_code;
  std::string says;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) {
  *stream << refusal.arguments;
}

class RefusedCommand : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedCommand, ExitsWithItsCodeAndSaysWhyOnStandardErrorOnly) {
  const CommandResult result = run_command(GetParam().arguments);
  EXPECT_EQ(result.exit_code, GetParam().exit_code);
  EXPECT_THAT(result.errors, HasSubstr(GetParam().says));
  EXPECT_THAT(result.output, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedCommand,
    testing::Values(
        Refusal{"NoCommand", "", 2, "A command is wanted.\nThere are: simulate, "},
        Refusal{"UnknownCommand", "dance", 2, "There is no command \"dance\".\nThere are: simulate, "},
        Refusal{"CommandWithASlip", "simulat", 2, "There is no command \"simulat\"; did you mean simulate?"},
        Refusal{"UnknownFlag", "simulate --bodys 3", 2, "has no flag \"--bodys\"; did you mean --bodies?"},
        Refusal{"UnknownFlagWithItsValue", "verify --modies=3", 2, "\"--modies\"; did you mean --bodies?"},
        Refusal{"FlagLikeNoOther", "simulate --xylophone", 2, "simulate has no flag \"--xylophone\"."},
        Refusal{"ArgumentTooMany", "engines please", 2, "engines has no use for \"please\"."},
        Refusal{"BodiesNotANumber", "simulate --bodies many", 2, "many"},
        Refusal{"NegativeBodies", "simulate --bodies -5", 2, "--bodies: a whole number, 0 to 4,294,967,296"},
        Refusal{"NegativeFrames", "verify --frames -1", 2, "--frames: a whole number, 0 or more"},
        Refusal{"HalfABody", "record --out a.npy --bodies 1.5", 2, "not \"1.5\""},
        Refusal{"NegativeReportFrame", "simulate --report-frames 1,-2", 2, "not \"-2\""},
        Refusal{"MovingThatIsNoNumber", "simulate --moving nan", 2, "--moving: a number, 0 to 1"},
        Refusal{"InfiniteSpeed", "simulate --speed inf", 2, "--speed: a number, 0 to 1000000"},
        Refusal{"NegativeSpeed", "verify --speed -1", 2, "not \"-1\""},
        Refusal{"ThreadsWithoutEnd", "simulate --engine stream --threads 5000", 2,
                "--threads is 5000; at most 1,024"},
        Refusal{"ThreadsBeyondNumbers", "simulate --engine stream --threads 99999999999999999999999", 2,
                "at most 1,024"},
        Refusal{"ThreadsByTheBillion", "verify --engine stream --threads 4000000000", 2,
                "--threads is 4000000000; at most 1,024"},
        Refusal{"NegativeThreads", "simulate --engine stream --threads -1", 2, "--threads is \"-1\""},
        Refusal{"ThreadsOfAPicture", "render --out a.png --threads 1025", 2, "0 to 1,024"},
        Refusal{"PictureOfAnotherKind", "render --out scene.jpg", 2, "scene.jpg"},
        Refusal{"ScreenshotOfAnotherKind", "view --screenshot it.gif", 2, "must be .png"},
        Refusal{"RecordingOfAnotherKind", "record --out it.csv --bodies 9", 2, "must be .aabbs or .npy"},
        Refusal{"AFileAndAScene", "verify it.npy --bodies 3", 2, "FILE excludes --bodies"},
        Refusal{"AFileAndGroups", "record --from it.npy --groups 2 --out it.npz", 2,
                "--from excludes --groups"},
        Refusal{"ARenderedFileAndAScene", "render it.npy --seed 3 --out it.png", 2, "FILE excludes --seed"},
        Refusal{"ARenderedFileAndStaticBodies", "render it.npy --static --out it.png", 2,
                "FILE excludes --static"},
        Refusal{"AShownFileAndAScene", "view it.npy --scene level", 2, "FILE excludes --scene"},
        Refusal{"AShownFileAndGroups", "view it.npy --groups 2", 2, "FILE excludes --groups"},
        Refusal{"WindowTooSmall", "view --width 9", 2, "640 to 8,192"},
        Refusal{"UnknownEngine", "simulate --engine nosuch", 2,
                "There is no engine \"nosuch\"; there are: control"},
        Refusal{"UnknownScene", "simulate --scene nosuch", 2, "nosuch"},
        Refusal{"MovingOfSleepers", "simulate --scene sleepers --moving 0.5", 2, "leave moving out"},
        Refusal{"SpinningScript", "simulate --scene stacks --spinning", 2, "leave spinning out"},
        Refusal{"GiantNowhere", "simulate --giant second", 2,
                "--giant: one of none, first, middle, last is wanted, not \"second\""},
        Refusal{"RecordedComeAndGo", "record --scene open-world --out open.npy", 2,
                "the bodies of open-world come and go"},
        Refusal{"MovingAboveOne", "simulate --moving 1.5", 2, "1.5"},
        Refusal{"ReportFrameNotReached", "simulate --frames 3 --report-frames 9", 2, "the last frame is 3"},
        Refusal{"MissingFile", "replay /no/such/file.aabbs", 2, "/no/such/file.aabbs"},
        Refusal{"UnknownEnding", "record --out scene.txt --bodies 10", 2, "scene.txt"},
        Refusal{"MoreBodiesThanFit", "simulate --bodies 5000 --engine control", 3, "5000 were asked for"},
        Refusal{"MoreBodiesThanASmallMapHolds", "simulate --bodies 3 --engine control --pair-map-bytes 64", 3,
                "raise --pair-map-bytes"},
        Refusal{"AMapForNoPair", "simulate --engine control --pair-map-bytes 1", 2,
                "one pair takes 64 bytes"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST(Command, RefusesATruncatedRecordingAndNamesThePlace) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path("short.aabbs")) << "too short";
  const CommandResult result = run_command("replay " + scratch.path("short.aabbs"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("short.aabbs"));
}

TEST(Command, RefusesAHundredGigabytesOfNothingAtOnce) {
  const ScratchFolder scratch;
  for (const std::string name : {"hole.aabbs", "hole.npy", "hole.npz"}) {
    std::error_code error;
    std::ofstream(scratch.path(name)) << "";
    std::filesystem::resize_file(scratch.path(name), 100'000'000'000, error);
    if (error) GTEST_SKIP() << "no room for a file with a hole";
    const CommandResult result = run_command("replay " + scratch.path(name));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.errors, AllOf(HasSubstr(name + ": "), HasSubstr("expected")));
  }
}

// Ten boxes in each of four million frames, all zeros: 1.3 GB, of which an address space of 0.3 GB has room
// for little.
TEST(Command, ReplaysARecordingThatIsLargerThanItsMemory) {
#if defined(CELLSWEEP_SANITIZED_TESTS) || defined(CELLSWEEP_EMULATED_TESTS)
  GTEST_SKIP() << "a sanitizer, and an emulator, needs the addresses for itself";
#endif
  const ScratchFolder scratch;
  const std::string file = scratch.path("long.aabbs");
  std::string head(304, '\0');
  head[256] = 10;
  constexpr std::uint32_t kUpdates = 3'999'999;
  for (std::size_t i = 0; i < 4; ++i) head[260 + i] = static_cast<char>(kUpdates >> (8 * i) & 0xff);
  std::ofstream(file, std::ios::binary) << head;
  std::filesystem::resize_file(file, 304 + std::uintmax_t{32} * 10 * (kUpdates + 1));
  const CommandResult result =
      run_command("replay " + file + " --engine stream --frames 5 --json", "ulimit -v 300000;");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(Json::parse(result.output)["engines"][0]["reports"][0]["pairs"], 45);
}

}  // namespace
}  // namespace cellsweep::app
