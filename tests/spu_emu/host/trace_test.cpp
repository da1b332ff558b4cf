// The timeline: valid JSON with one row for each SPE and spans that nest.
#include <chrono>
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
        EXPECT_EQ(event.at("args").at("bytes"), event.at("args").at("size"));
        EXPECT_NE(event.at("args").at("source").get<std::string>().find("probe_spu.cpp"), std::string::npos);
      }
    }
    EXPECT_EQ(rows.size(), 2U);
    EXPECT_EQ(gets, 33);
  }
}

TEST(Trace, becomes_part_of_another_timeline_with_times_from_its_origin) {
  take_trace();
  const auto origin = std::chrono::steady_clock::now();
  EmulationSettings settings;
  settings.trace = true;
  TestContext context(settings);
  context.exit_code(Probe::return_parameter);
  std::ostringstream events;
  events << '[';
  write_trace_events(events, origin);
  events << "{}]";
  const nlohmann::json rows = nlohmann::json::parse(events.str());
  ASSERT_EQ(rows.size(), 3U);  // the row's name, its one run, and what was put behind the last comma
  EXPECT_EQ(rows[1].at("name"), "run");
  EXPECT_GE(rows[1].at("ts"), 0.0);
  const std::chrono::duration<double, std::micro> until_now = std::chrono::steady_clock::now() - origin;
  EXPECT_LE(rows[1].at("ts").get<double>() + rows[1].at("dur").get<double>(), until_now.count());
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
