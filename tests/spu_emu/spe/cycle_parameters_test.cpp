// The numbers of the cycle model by name.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "spu_emu/emulation.h"

namespace spu_emu {
namespace {

TEST(CycleParameters, EachHasANameAMeaningAndASource) {
  std::set<std::string_view> names;
  for (const CycleParameter& each : cycle_parameters()) {
    EXPECT_TRUE(names.insert(each.name).second) << each.name << " is there twice";
    EXPECT_FALSE(each.meaning.empty()) << each.name;
    EXPECT_FALSE(each.source.empty()) << each.name;
  }
}

TEST(CycleParameters, EachIsSetByItsNameAlone) {
  const CycleParameters defaults;
  for (const CycleParameter& each : cycle_parameters()) {
    CycleParameters changed;
    const double value = cycle_parameter(defaults, each.name) + 1;
    set_cycle_parameter(changed, each.name, value);
    for (const CycleParameter& other : cycle_parameters()) {
      const double wanted = other.name == each.name ? value : cycle_parameter(defaults, other.name);
      EXPECT_EQ(cycle_parameter(changed, other.name), wanted) << each.name << " changed " << other.name;
    }
  }
}

TEST(CycleParameters, AreTheMembersOfTheirNames) {
  CycleParameters parameters;
  set_cycle_parameter(parameters, "memory_latency", 500);
  set_cycle_parameter(parameters, "memory_bytes_per_cycle", 7.5);
  set_cycle_parameter(parameters, "sharing_spes", 6);
  set_cycle_parameter(parameters, "hint_seen", 0);
  EXPECT_EQ(parameters.memory_latency, 500U);
  EXPECT_EQ(parameters.memory_bytes_per_cycle, 7.5);
  EXPECT_EQ(parameters.sharing_spes, 6U);
  EXPECT_EQ(parameters.hint_seen, 0U);
}

TEST(CycleParameters, RefuseWhatCannotBe) {
  CycleParameters parameters;
  EXPECT_THROW(set_cycle_parameter(parameters, "no_such", 1), std::invalid_argument);
  EXPECT_THROW(set_cycle_parameter(parameters, "sharing_spes", 0), std::invalid_argument);
  EXPECT_THROW(set_cycle_parameter(parameters, "branch_miss", 1.5), std::invalid_argument);
  EXPECT_THROW(set_cycle_parameter(parameters, "branch_miss", -1), std::invalid_argument);
  EXPECT_THROW(set_cycle_parameter(parameters, "branch_miss", 1e9), std::invalid_argument);
  EXPECT_THROW(set_cycle_parameter(parameters, "memory_bytes_per_cycle", 0), std::invalid_argument);
  EXPECT_EQ(parameters.branch_miss, CycleParameters().branch_miss);
}

TEST(CycleParameters, AreTakenAsAssignments) {
  CycleParameters parameters;
  set_cycle_parameter(parameters, std::string("memory_latency=500"));
  EXPECT_EQ(parameters.memory_latency, 500U);
  for (const std::string wrong : {"memory_latency", "memory_latency=", "memory_latency=5x", "=5", "x=5"})
    EXPECT_THROW(set_cycle_parameter(parameters, wrong), std::invalid_argument) << wrong;
}

TEST(CycleParameters, AreCheckedWithTheSettings) {
  EmulationSettings settings;
  settings.cycles.emplace();
  settings.cycles->bus_line = 0;
  EXPECT_THROW(SettingsScope{settings}, std::invalid_argument);
}

TEST(Stalls, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kStalls; ++i) names.insert(stall_name(static_cast<Stall>(i)));
  EXPECT_EQ(names.size(), kStalls);
}

}  // namespace
}  // namespace spu_emu
