// Cycles and their parameters as spu-run prints them.
#include <gtest/gtest.h>

#include "tools/cycle_table.h"

namespace spu_emu {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CycleTable, ShowsTotalsStallsAndTheMostExpensiveFunctionFirst) {
  CycleProfile profile;
  CycleCounts small;
  small.cycles = 100;
  small.instructions = 50;
  CycleCounts large;
  large.cycles = 3100;
  large.instructions = 1000;
  large.stalls[static_cast<std::size_t>(Stall::load)] = 2200;
  profile.functions = {{"small", small}, {"large", large}};
  profile.total = small;
  profile.total += large;
  const std::string text = cycle_table(profile, 3.2e9);
  EXPECT_TRUE(has(text, "3200 (1.000 us at 3.2 GHz)")) << text;
  EXPECT_TRUE(has(text, "load 71 %")) << text;
  EXPECT_LT(text.find("large"), text.find("small"));
}

TEST(CycleTable, ListsEveryParameterWithItsSource) {
  const std::string text = cycle_parameter_table({});
  for (const CycleParameter& each : cycle_parameters()) {
    EXPECT_TRUE(has(text, std::string(each.name))) << each.name;
    EXPECT_TRUE(has(text, std::string(each.source))) << each.name;
  }
}

}  // namespace
}  // namespace spu_emu
