#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command_line.h"
#include "project_file.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;

Json map_of(const std::string& flags) {
  return Json::parse(run_command("local-store --engine cell-paper --json " + flags).output)["maps"][0];
}

/// Not where all programs are a real SPU's.
bool has_local_stores_without_limit() {
  return run_command("local-store --engine cell-paper --local-store off").exit_code == 0;
}

TEST(CellCommand, PrintsTheMapOfALocalStore) {
  const CommandResult result = run_command("local-store --engine cell-paper --bodies 1024");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  for (const char* part : {"code", "stack", "values", "keys", "together", "limit", "free"}) {
    EXPECT_THAT(result.output, HasSubstr(part));
  }
}

TEST(CellCommand, ExitsWith3WhenTheBodiesDoNotFit) {
  const CommandResult result = run_command("local-store --engine cell-paper --bodies 100000");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.output, HasSubstr("too many"));
}

TEST(CellCommand, TheMapFollowsTheSettings) {
  EXPECT_EQ(map_of("")["limit_bytes"], 262144);
  EXPECT_EQ(map_of("--local-store 128K")["limit_bytes"], 131072);
  EXPECT_GT(map_of("--method 2")["used_bytes"], map_of("--method 1")["used_bytes"]);
  EXPECT_GT(map_of("--list-dma")["used_bytes"], map_of("")["used_bytes"]);
}

TEST(CellCommand, ALocalStoreWithoutALimitHoldsWhatNoneElseDoes) {
  if (!has_local_stores_without_limit()) GTEST_SKIP() << "all programs are a real SPU's";
  EXPECT_EQ(map_of("--local-store off")["limit_bytes"], 0);
  EXPECT_EQ(run_command("local-store --engine cell-paper --bodies 100000 --local-store off").exit_code, 0);
  EXPECT_EQ(run_command("verify --engine cell-paper --bodies 100 --frames 5 --local-store off").exit_code, 0);
}

TEST(CellCommand, RefusesAnEngineWithoutALocalStore) {
  const CommandResult result = run_command("local-store --engine control");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("no local store"));
}

TEST(CellCommand, RunsWithEverySetting) {
  for (const std::string flags :
       {"--method 2", "--list-dma", "--dma late --dma-seed 9", "--dma unchecked", "--spus 2"}) {
    const CommandResult result =
        run_command("verify --engine cell-paper,cell-brute --bodies 100 --frames 5 " + flags);
    EXPECT_EQ(result.exit_code, 0) << flags << result.output << result.errors;
  }
}

TEST(CellCommand, MakesBoxesOnTheSpusThatAreVerifiedAsTheyAre) {
  for (const std::string flags : {"", " --dma late --spus 5"}) {
    const CommandResult result = run_command(
        "verify --engine cell-resident --spu-boxes --scene varied --bodies 150 --moving 1 --spinning "
        "--frames 20" +
        flags);
    EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
    EXPECT_THAT(result.output, HasSubstr("exact"));
  }
  const CommandResult no_poses = run_command("verify --engine cell-resident --spu-boxes --scene pile");
  EXPECT_EQ(no_poses.exit_code, 2);
  EXPECT_THAT(no_poses.errors, HasSubstr("has boxes only"));
  const std::string local_store = "local-store --engine cell-resident --bodies 100";
  EXPECT_THAT(run_command(local_store + " --spu-boxes").output, HasSubstr("intervals of poses"));
  EXPECT_THAT(run_command(local_store).output, Not(HasSubstr("poses")));
}

TEST(CellCommand, RefusesPosesForEnginesThatMakeNoBoxesAndOfSourcesThatHaveNone) {
  const CommandResult control = run_command("simulate --engine control --spu-boxes --bodies 10 --frames 1");
  EXPECT_EQ(control.exit_code, 2);
  EXPECT_THAT(control.errors, HasSubstr("cell-resident"));
  const CommandResult recording =
      run_command("replay " + project_file("bench/scenes/bullet-towers-1024.aabbs") +
                  " --engine cell-resident --spu-boxes");
  EXPECT_EQ(recording.exit_code, 2);
  EXPECT_THAT(recording.errors, HasSubstr("poses"));
}

TEST(CellCommand, RefusesSettingsThatAreNotThere) {
  for (const std::string flags : {"--method 3", "--dma sometimes", "--local-store 5", "--local-store on"}) {
    EXPECT_EQ(run_command("verify --engine cell-paper --bodies 10 --frames 1 " + flags).exit_code, 2)
        << flags;
  }
}

TEST(CellCommand, RefusesCyclesOfProgramsForThisMachineAndOfEnginesWithoutSpes) {
  const std::string run = "simulate --cycles --bodies 10 --frames 1 --engine ";
  const CommandResult host = run_command(run + "cell-paper");
  EXPECT_EQ(host.exit_code, 2);
  EXPECT_THAT(host.errors, HasSubstr("--spe-engine isa"));
  const CommandResult control = run_command(run + "control");
  EXPECT_EQ(control.exit_code, 2);
  EXPECT_THAT(control.errors, HasSubstr("it is one of cell-paper, cell-brute, cell-resident, cell-stream"));
  EXPECT_EQ(run_command("verify --cycles --bodies 10 --frames 1").exit_code, 2) << "it shows no times";
}

TEST(CellCommand, GivesPosesToTheEngineThatTakesThemAndBoxesToOthers) {
  const CommandResult result =
      run_command("verify --engine control,cell-resident --spu-boxes --bodies 50 --spinning --frames 5");
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
}

TEST(CellCommand, ShowsAFramesTimeOnACell) {
  const std::string run =
      "simulate --engine cell-paper --spe-engine isa --cycles --bodies 32 --moving 0.5 --frames 3 ";
  const CommandResult table = run_command(run);
  if (table.exit_code == 2) GTEST_SKIP() << "built without the SPU compiler";
  EXPECT_EQ(table.exit_code, 0) << table.errors;
  for (const char* part : {"Cell time", "DMA wait", "initial", "dynamic", "SPE start", "PPU"})
    EXPECT_THAT(table.output, HasSubstr(part));
  const auto cell_of = [&](const std::string& flags) {
    return Json::parse(run_command(run + "--json " + flags).output)["engines"][0]["cell"];
  };
  const Json cell = cell_of("--ppu-factor 2 --spu-start-us 100");
  EXPECT_EQ(cell["ppu_factor"], 2);
  EXPECT_EQ(cell["frames"][0]["spu_start_us"], 100);
  EXPECT_EQ(cell["frames"][0]["spes"].size(), 3U);
  EXPECT_GT(cell_of("--cycle-parameter memory_latency=9000")["frames"][0]["spu_us"],
            cell["frames"][0]["spu_us"]);
  EXPECT_EQ(run_command(run + "--cycle-parameter memory_latency=x").exit_code, 2);
}

TEST(CellCommand, LiteralDiffersFromTheOracleAndSaysByHowMuch) {
  const CommandResult result = run_command(
      "verify --engine cell-paper --literal --scene varied --bodies 150 --moving 0.5 --frames 20");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.output, HasSubstr("differs"));
}

}  // namespace
}  // namespace cellsweep::app
