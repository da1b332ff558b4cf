/// @file
/// The timeline that an engine writes: rows, spans, and what the statistics say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "cellsweep/world/scene.h"
#include "every_engine.h"

namespace cellsweep {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

// Times are whole nanoseconds, written in microseconds.
constexpr double kRounding = 1e-5;
constexpr std::uint64_t kUpdates = 4;

struct Span {
  std::string name;
  double begin = 0;
  double duration = 0;
  Json arguments;

  double end() const { return begin + duration; }
};

/// A timeline as it was read back: names and spans by row.
struct Rows {
  std::map<unsigned, std::string> names;
  std::map<unsigned, std::vector<Span>> spans;

  /// Spans of all rows whose name begins so.
  std::vector<Span> of(const std::string& beginning) const {
    std::vector<Span> found;
    for (const auto& [row, name] : names) {
      if (name.rfind(beginning, 0) != 0 || !spans.contains(row)) continue;
      found.insert(found.end(), spans.at(row).begin(), spans.at(row).end());
    }
    return found;
  }
};

Rows read_rows(const std::string& path) {
  Rows rows;
  const Json timeline = Json::parse(std::ifstream(path));
  for (const Json& event : timeline.at("traceEvents")) {
    if (event.at("ph") == "M" && event.at("name") == "thread_name")
      rows.names[event.at("tid")] = event.at("args").at("name");
    if (event.at("ph") != "X") continue;
    rows.spans[event.at("tid")].push_back(
        {event.at("name"), event.at("ts"), event.at("dur"), event.value("args", Json::object())});
  }
  return rows;
}

std::vector<Span> named(std::vector<Span> spans, const std::string& beginning) {
  std::erase_if(spans, [&](const Span& span) { return span.name.rfind(beginning, 0) != 0; });
  return spans;
}

std::uint64_t bytes_of(const std::vector<Span>& spans) {
  std::uint64_t sum = 0;
  for (const Span& span : spans) sum += span.arguments.at("bytes").get<std::uint64_t>();
  return sum;
}

/// A short run with a timeline: what the engine said of it, and the timeline.
struct TracedRun {
  std::vector<std::vector<Phase>> phases;  // of each update
  std::map<std::string, std::uint64_t, std::less<>> counters;
#ifdef CELLSWEEP_HAS_CELL
  std::optional<CellStatistics> spes;
#endif
  Rows rows;
};

void work(Broadphase& engine, TracedRun& run) {
  auto source = make_scene_frames({.scene = "paper", .bodies = 120, .moving = 0.5});
  std::vector<BodyId> ids(120);
  for (BodyId id = 0; id < ids.size(); ++id) ids[id] = id;
  ASSERT_TRUE(engine.insert(ids, (*source)->boxes()).ok());
  for (std::uint64_t update = 0; update < kUpdates; ++update) {
    if (update != 0) {
      (*source)->advance();
      ASSERT_TRUE(engine.move(ids, (*source)->boxes()).ok());
    }
    ASSERT_TRUE(engine.update().ok());
    run.phases.push_back(engine.statistics().phases);
  }
  for (const Counter& counter : engine.statistics().counters)
    run.counters[std::string(counter.name)] = counter.value;
#ifdef CELLSWEEP_HAS_CELL
  run.spes = cell_statistics(engine);
#endif
}

TracedRun traced_run(std::string_view name, SettingValues settings = {}) {
  const std::string path = testing::TempDir() + "/timeline-" + std::to_string(getpid()) + ".json";
  settings.emplace_back("trace", path);
  TracedRun run;
  {
    auto engine = make_broadphase(name, settings);
    EXPECT_TRUE(engine.ok()) << engine.status().message;
    if (engine) work(*engine, run);
  }
  run.rows = read_rows(path);
  std::filesystem::remove(path);
  return run;
}

bool is_cell(std::string_view name) {
  return name.starts_with("cell-");
}

class TimelineOfEngine : public testing::TestWithParam<std::string> {};

TEST_P(TimelineOfEngine, HasANamedRowForTheHostAndForEachSpeThatWorks) {
  const Rows rows = traced_run(GetParam()).rows;
  std::vector<std::string> names;
  for (const auto& [row, name] : rows.names) names.push_back(name);
  EXPECT_THAT(names, Contains(is_cell(GetParam()) ? "PPU, " + GetParam() : GetParam()));
  const std::size_t spes = GetParam() == "cell-stream" ? 1 : 3;  // so few bodies are a single piece
  EXPECT_EQ(names.size(), is_cell(GetParam()) ? 1 + spes : 1);
  for (const auto& [row, spans] : rows.spans) EXPECT_TRUE(rows.names.contains(row)) << row;
}

TEST_P(TimelineOfEngine, HasSpansThatNestOrAreApart) {
  const Rows rows = traced_run(GetParam()).rows;
  for (const auto& [row, spans] : rows.spans) {
    std::vector<double> open_until;
    for (const Span& span : spans) {
      while (!open_until.empty() && open_until.back() <= span.begin + kRounding) open_until.pop_back();
      EXPECT_LE(span.end(), open_until.empty() ? span.end() : open_until.back() + kRounding)
          << rows.names.at(row) << ": " << span.name;
      open_until.push_back(span.end());
    }
  }
}

TEST_P(TimelineOfEngine, HasThePhasesOfEveryUpdateAsTheStatisticsTellThem) {
  const TracedRun run = traced_run(GetParam());
  const std::vector<Span> spans = run.rows.of(is_cell(GetParam()) ? "PPU" : GetParam());
  const std::vector<Span> updates = named(spans, "update");
  ASSERT_EQ(named(spans, "insert").size(), 1U);
  ASSERT_EQ(named(spans, "move").size(), kUpdates - 1);
  std::size_t at = 0;
  for (const std::vector<Phase>& phases : run.phases) {
    while (at < spans.size() && spans[at].name != "update") ++at;
    ASSERT_LT(at, spans.size());
    const Span& update = spans[at++];
    double sum = 0;
    for (const Phase& phase : phases) {
      while (at < spans.size() && spans[at].name != phase.name) ++at;
      ASSERT_LT(at, spans.size()) << phase.name;
      EXPECT_NEAR(spans[at].duration, 1000 * phase.milliseconds, kRounding) << phase.name;
      EXPECT_GE(spans[at].begin, update.begin - kRounding) << phase.name;
      sum += spans[at++].duration;
    }
    EXPECT_FALSE(phases.empty());
    EXPECT_LE(sum, update.duration + kRounding * static_cast<double>(phases.size() + 1));
  }
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const EngineInfo& info : every_engine()) names.emplace_back(info.name);
  return names;
}

std::string name_of_case(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(EveryEngine, TimelineOfEngine, testing::ValuesIn(engine_names()), name_of_case);

#ifdef CELLSWEEP_HAS_CELL

void expect_all_transfers(const TracedRun& run) {
  const std::vector<Span> spes = run.rows.of("SPE");
  EXPECT_EQ(named(spes, "get").size(), run.spes->dma_gets);
  EXPECT_EQ(named(spes, "put").size(), run.spes->dma_puts);
  EXPECT_EQ(bytes_of(named(spes, "get")), run.spes->dma_bytes_in);
  EXPECT_EQ(bytes_of(named(spes, "put")), run.spes->dma_bytes_out);
  EXPECT_GT(bytes_of(named(spes, "get")), 0U);
  EXPECT_GT(bytes_of(named(spes, "put")), 0U);
}

TEST(Timeline, HasEveryTransferThatTheStatisticsCount) {
  for (const char* mode : {"eager", "late", "unchecked"}) {
    for (const char* engine : {"cell-resident", "cell-brute", "cell-paper", "cell-stream"})
      expect_all_transfers(traced_run(engine, {{"dma", mode}}));
    expect_all_transfers(traced_run("cell-paper", {{"dma", mode}, {"list_dma", "true"}}));
  }
}

TEST(Timeline, HasTheRunOfEachProgramThatIsStartedEachFrame) {
  const Rows rows = traced_run("cell-paper").rows;
  EXPECT_EQ(named(rows.of("SPE"), "run").size(), 3 * kUpdates);
  EXPECT_EQ(named(rows.of("PPU"), "wait for SPEs to end").size(), kUpdates);
}

TEST(Timeline, HasTheWaitsForMailboxesOfProgramsThatStay) {
  const TracedRun run = traced_run("cell-resident");
  const std::vector<Span> spes = run.rows.of("SPE");
  EXPECT_EQ(named(spes, "run").size(), 3U);
  EXPECT_THAT(named(run.rows.of("PPU"), "wait for mailboxes"), Not(IsEmpty()));
  // A program may find an order there already, and then it does not wait.
  const std::vector<Span> waits = named(spes, "read in mailbox");
  EXPECT_THAT(waits, Not(IsEmpty()));
  EXPECT_LE(waits.size(), run.counters.at("mailbox words") + 3);
}

TEST(Timeline, IsOneForAllEnginesThatNameTheFile) {
  const std::string path = testing::TempDir() + "/timeline-shared-" + std::to_string(getpid()) + ".json";
  TracedRun ignored;
  {
    Broadphase one = std::move(*make_broadphase(ControlOptions{.trace = path}));
    Broadphase other = std::move(*make_broadphase(CellBruteOptions{.trace = path}));
    work(one, ignored);
    work(other, ignored);
  }
  const Rows rows = read_rows(path);
  std::filesystem::remove(path);
  EXPECT_EQ(named(rows.of("control"), "update").size(), kUpdates);
  EXPECT_EQ(named(rows.of("PPU, cell-brute"), "update").size(), kUpdates);
  EXPECT_THAT(rows.of("SPE"), Not(IsEmpty()));
}

#endif

TEST(Timeline, IsRefusedWhereItCannotBeWritten) {
  for (const EngineInfo& info : every_engine()) {
    const auto made = make_broadphase(info.name, {{"trace", "/nonexistent/trace.json"}});
    ASSERT_FALSE(made.ok()) << info.name;
    EXPECT_EQ(made.status().code, StatusCode::bad_option) << info.name;
    EXPECT_EQ(made.status().setting, "trace") << info.name;
  }
}

}  // namespace
}  // namespace cellsweep
