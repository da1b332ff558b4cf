/// @file
/// The engine table: every row makes an engine, and no other name does.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "contract/contract_engines.h"

namespace cellsweep::contract {
namespace {

TEST(EngineTable, EveryNameIsThereOnceAndHasASummary) {
  std::set<std::string_view> names;
  for (const EngineInfo& info : engine_table()) {
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.summary.empty()) << info.name;
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " is listed twice";
  }
  EXPECT_FALSE(names.empty());
}

TEST(EngineTable, EveryRowMakesAnEngineOfItsName) {
  for (const EngineInfo& info : engine_table()) {
    const auto made = make_engine(info.name);
    ASSERT_TRUE(made.ok()) << info.name << ": " << made.status().message;
    EXPECT_EQ((*made)->name(), info.name);
  }
}

TEST(EngineTable, AnUnknownNameIsRefusedWithTheNamesThatAreKnown) {
  for (const std::string_view name : {"no such engine", "", "CONTROL", "control ", "contro"}) {
    const auto made = make_engine(name);
    ASSERT_FALSE(made.ok()) << '"' << name << '"';
    EXPECT_EQ(made.status().code, StatusCode::bad_option);
    for (const EngineInfo& info : engine_table()) {
      EXPECT_THAT(made.status().message, testing::HasSubstr(std::string(info.name)));
    }
  }
}

TEST(ContractSuite, RunsOnEveryEngineWithItsDefaultsAndOnNoneThatIsNotExact) {
  for (const EngineInfo& info : engine_table()) {
    EXPECT_TRUE(std::ranges::any_of(contract_engines(), [&](const ContractEngine& engine) {
      return engine.name == info.name && engine.label.find("_with_") == std::string::npos;
    })) << info.name;
  }
  for (const ContractEngine& engine : contract_engines())
    EXPECT_FALSE(engine.options.literal) << engine.label;
}

}  // namespace
}  // namespace cellsweep::contract
