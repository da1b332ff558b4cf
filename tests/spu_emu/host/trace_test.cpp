// The timeline: valid JSON with one row for each SPE and spans that nest.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "test_context.h"

namespace spu_emu {
namespace {

nlohmann::json take_trace() {
  std::ostringstream out;
  write_trace(out);
  return nlohmann::json::parse(out.str());
}

TEST(Trace, rows_are_spes_and_spans_nest_in_every_mode) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late, DmaMode::unchecked}) {
    take_trace();
    EmulationSettings settings = settings_of(mode);
    settings.trace = true;
    TestContext one(settings);
    TestContext two(settings);
    const Words words;
    one.exit_code(Probe::sum_into_global, &words);
    two.exit_code(Probe::many_gets, &words);
    const nlohmann::json trace = take_trace();
    std::set<int> rows;
    std::vector<double> open_until;
    int last_row = -1;
    int gets = 0;
    for (const auto& event : trace.at("traceEvents")) {
      if (event.at("ph") != "X") continue;
      const int row = event.at("tid");
      const double begin = event.at("ts");
      const double end = begin + event.at("dur").get<double>();
      if (row != last_row) open_until.clear();
      last_row = row;
      rows.insert(row);
      constexpr double kRounding = 0.0021;
      while (!open_until.empty() && open_until.back() <= begin + kRounding) open_until.pop_back();
      EXPECT_LE(end, open_until.empty() ? end : open_until.back() + kRounding);
      open_until.push_back(end);
      if (event.at("name") == "get") {
        ++gets;
        EXPECT_TRUE(event.at("args").contains("size"));
        EXPECT_NE(event.at("args").at("source").get<std::string>().find("probe_spu.cpp"), std::string::npos);
      }
    }
    EXPECT_EQ(rows.size(), 2U);
    EXPECT_EQ(gets, 33);
  }
}

TEST(Trace, is_empty_unless_asked_for_and_valid_then) {
  take_trace();
  TestContext context;
  context.exit_code(Probe::return_parameter);
  const nlohmann::json trace = take_trace();
  for (const auto& event : trace.at("traceEvents")) EXPECT_EQ(event.at("ph"), "M");
}

}  // namespace
}  // namespace spu_emu
