#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "cellsweep/engines.h"
#include "command_line.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

constexpr const char* kSmall = "simulate --bodies 20 --frames 2 ";

std::string flag_of(std::string_view setting) {
  std::string flag = "--" + std::string(setting);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

TEST(EngineFlags, AreTheSettingsOfTheEngineTable) {
  const std::string help = run_command("simulate --help").output;
  for (const EngineInfo& engine : engine_table()) {
    for (const SettingInfo& setting : engine.settings)
      EXPECT_THAT(help, HasSubstr("\n  " + flag_of(setting.name))) << engine.name;
  }
}

TEST(EngineFlags, SayInHelpWhichEnginesHaveThem) {
  const std::string help = run_command("verify --help").output;
  const std::string entry = help.substr(help.find("--pair-map-bytes"));
  EXPECT_THAT(entry.substr(0, entry.find("\n  --")), HasSubstr("(control"));
  EXPECT_THAT(entry.substr(0, entry.find("\n  --")), HasSubstr("[512M]"));
}

TEST(EngineFlags, AreRefusedForAnEngineThatDoesNotHaveThem) {
  const CommandResult result = run_command(std::string(kSmall) + "--engine stream --pair-map-bytes 512M");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--pair-map-bytes is no setting of stream; it is one of control"));
  EXPECT_THAT(result.output, IsEmpty());
}

TEST(EngineFlags, GoToThoseOfSeveralEnginesThatHaveThem) {
  const CommandResult both =
      run_command(std::string(kSmall) + "--engine control,stream --pair-map-bytes 512M --threads 1 --json");
  EXPECT_EQ(both.exit_code, 0) << both.errors;
  EXPECT_EQ(Json::parse(both.output)["engines"].size(), 2U);
  EXPECT_EQ(run_command(std::string(kSmall) + "--max-pairs 1000000").exit_code, 0) << "the whole table";
  const CommandResult none = run_command(std::string(kSmall) + "--engine oracle,control --threads 2");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.errors, HasSubstr("--threads is no setting of oracle, control; it is one of stream"));
}

TEST(EngineFlags, TakeSizes) {
  const auto holds = [](const std::string& size) {
    // A map of 64 bytes a pair: 45 pairs are those of ten bodies.
    return run_command("simulate --frames 0 --engine control --bodies 10 --pair-map-bytes " + size).exit_code;
  };
  EXPECT_EQ(holds("2880"), 0);
  EXPECT_EQ(holds("2879"), 3);
  EXPECT_EQ(holds("3K"), 0);
  EXPECT_EQ(holds("3kb"), 0);
  EXPECT_EQ(holds("2K"), 3);
  for (const std::string size : {"many", "5X", "-3K", "M", "99999999999999999999G", "off"}) {
    EXPECT_EQ(holds(size), 2) << size;
  }
}

TEST(EngineFlags, StandInTheRefusalsOfTheLibrary) {
  const CommandResult map = run_command("simulate --engine control --pair-map-bytes 1");
  EXPECT_EQ(map.exit_code, 2);
  EXPECT_THAT(map.errors, HasSubstr("--pair-map-bytes"));
  EXPECT_THAT(map.errors, Not(HasSubstr("pair_map_bytes")));
  const CommandResult margin = run_command("simulate --engine stream --margin -0.5");
  EXPECT_EQ(margin.exit_code, 2);
  EXPECT_THAT(margin.errors, HasSubstr("--margin is \"-0.5\""));
  const CommandResult isa = run_command("simulate --engine stream --isa mmx");
  EXPECT_EQ(isa.exit_code, 2);
  EXPECT_THAT(isa.errors, HasSubstr("--isa"));
  EXPECT_THAT(isa.errors, HasSubstr("portable"));
}

TEST(EngineFlags, LeaveOutOfTheWholeTableWhatDoesNotHoldTheBodiesAndSaySo) {
  const CommandResult result = run_command("simulate --bodies 5000 --frames 1 --moving 0.01 --json");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, HasSubstr("Engine control is left out: it holds 4,096 bodies"));
  const Json report = Json::parse(result.output);
  for (const Json& engine : report["engines"]) EXPECT_NE(engine["engine"], "control");
}

TEST(EngineFlags, LeaveOutTheOracleWhereItWouldTakeLongUnlessItIsAskedFor) {
  const std::string run = "simulate --bodies 20001 --frames 0 --json --seed 3";
  const CommandResult all = run_command(run);
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_THAT(all.errors, HasSubstr("Engine oracle is left out"));
#ifndef CELLSWEEP_SANITIZED_TESTS
  const CommandResult asked = run_command(run + " --engine stream,oracle");
  EXPECT_EQ(asked.exit_code, 0);
  EXPECT_THAT(asked.errors, IsEmpty());
  const Json engines = Json::parse(asked.output)["engines"];
  EXPECT_EQ(engines[0]["reports"], engines[1]["reports"]);
#endif
}

}  // namespace
}  // namespace cellsweep::app
