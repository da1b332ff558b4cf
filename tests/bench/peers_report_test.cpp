#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "bench/measured/page_marks.h"
#include "bench/peers/chart/chart_script.h"
#include "bench/peers/chart/pages.h"
#include "bench/peers/chart/ratios.h"
#include "bench/peers/chart/tables.h"
#include "bench/peers/peer_mode.h"
#include "report/text_file.h"

namespace cellsweep::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A row as Google Benchmark writes it.
std::string row(const std::string& name, double time, const std::string& more = "") {
  return R"({"run_name": ")" + name + R"(/iterations:1/manual_time", "run_type": "iteration", )" +
         R"("time_unit": "us", "real_time": )" + std::to_string(time) + more + "},\n";
}

std::string file(std::string rows) {
  rows.erase(rows.find_last_of(','));
  return R"({"context": {"cpu": "a Cell", "cores": "9"}, "benchmarks": [)" + rows + "]}";
}

PeerResults results_of(const std::string& rows) {
  PeerResults results;
  const Status status = add_results(file(rows), results);
  EXPECT_TRUE(status.ok()) << status.message;
  return results;
}

constexpr CellKey kUniform1000Initial{0, 1000, 0};

std::string two_cells() {
  return row("peers/memory/uniform/1000/initial", 5) + row("peers/stream/uniform/1000/initial", 10) +
         row("peers/stream_1/uniform/1000/initial", 1) + row("peers/slow/uniform/1000/initial", 80) +
         row("peers/quick/uniform/1000/initial", 40) +
         row("peers/wrong/uniform/1000/initial", 20, R"(, "missing": 3)") +
         row("peers/stream/wall/1000/initial", 100) + row("peers/slow/wall/1000/initial", 900);
}

TEST(PeerResults, NamePeersInTheOrderOfTheFile) {
  const PeerResults results = results_of(two_cells());
  EXPECT_DOUBLE_EQ(results.cells.at(kUniform1000Initial).at("quick").seconds, 40e-6);
  EXPECT_THAT(results.peers, ElementsAre("memory", "stream", "stream_1", "slow", "quick", "wrong"));
}

TEST(PeerResults, TakeTheRowInTheMiddleOfPeersThatTookTurns) {
  const std::string stream = "peers/stream/uniform/1000/initial";
  const std::string quick = "peers/quick/uniform/1000/initial";
  const PeerResults results = results_of(
      row(stream, 14, R"(, "p99": 3)") + row(quick, 70) + row(stream, 10, R"(, "p99": 1)") + row(quick, 90) +
      row(stream, 12, R"(, "p99": 2)") + row(quick, 80) + row(stream, 0, R"(, "error_occurred": true)"));
  const PeerTime& time = results.cells.at(kUniform1000Initial).at("stream");
  EXPECT_DOUBLE_EQ(time.seconds, 12e-6);
  EXPECT_DOUBLE_EQ(time.p99, 2e-6);
  EXPECT_NEAR(time.spread, 2.0 / 12, 1e-12);
  EXPECT_DOUBLE_EQ(results.cells.at(kUniform1000Initial).at("quick").seconds, 80e-6);
}

TEST(PeerResults, KeepWhatAnEarlierFileSaid) {
  PeerResults results = results_of(row("peers/stream/uniform/1000/initial", 10));
  const std::string later =
      file(row("peers/stream/uniform/1000/initial", 99) + row("peers/stream/uniform/1000000/initial", 30));
  ASSERT_TRUE(add_results(later, results).ok());
  EXPECT_DOUBLE_EQ(results.cells.at(kUniform1000Initial).at("stream").seconds, 10e-6);
  EXPECT_EQ(results.cells.size(), 2U);
}

TEST(PeerResults, AreNotReadFromAnythingElse) {
  PeerResults results;
  EXPECT_FALSE(add_results("peers/stream", results).ok());
  EXPECT_TRUE(add_results(file(row("engine/stream/uniform/1000/initial", 1)), results).ok());
  EXPECT_TRUE(results.cells.empty());
}

TEST(PeerRatios, CompareStreamWithTheFastestExactOther) {
  const std::vector<CellRatio> ratios = ratios_of(results_of(two_cells()));
  ASSERT_EQ(ratios.size(), 2U);
  EXPECT_EQ(ratios[0].best, "quick");
  EXPECT_DOUBLE_EQ(ratios[0].ratio(), 4);
  EXPECT_DOUBLE_EQ(ratios[0].over_memory(), 2);
  EXPECT_EQ(ratios[1].best, "slow");
  EXPECT_DOUBLE_EQ(ratios[1].ratio(), 9);
  EXPECT_DOUBLE_EQ(summarise(ratios)->mean, 6);
  EXPECT_DOUBLE_EQ(summarise(ratios)->smallest.ratio(), 4);
  EXPECT_FALSE(summarise({}).has_value());
}

TEST(PeerTables, SayTheMeanTheSmallestRatioAndWhoWasNotExact) {
  const std::string table = summary_markdown(results_of(two_cells()));
  EXPECT_THAT(table, HasSubstr("| 1,000 | **6.0**; 4.0 (uniform, `quick`) |"));
  EXPECT_THAT(table, HasSubstr("all 2 cells: 6.0; 2 of them are 2 or more"));
  EXPECT_THAT(table, HasSubstr("`wrong` was off by 3 pairs in 1 cells"));
}

TEST(PeerTables, HaveARowForEachCell) {
  const std::string table = cells_markdown(results_of(two_cells()));
  EXPECT_THAT(table,
              HasSubstr("| uniform | 1,000 | all new | 0 | 10.0 µs |  | `quick` | 40.0 µs |  | 4.0 | 2.0 |"));
  EXPECT_THAT(table, HasSubstr("| wall | 1,000 | all new | 0 | 100 µs |  | `slow` | 900 µs |  | 9.0 |  |"));
  EXPECT_THAT(times_csv(results_of(two_cells())), HasSubstr("uniform,1000,initial,wrong,"));
}

TEST(PeerTables, ShowMediansAndPercentilesBesideMeans) {
  const PeerResults results =
      results_of(row("peers/stream/open-world/1000/own", 10, R"(, "median": 12, "p99": 31)") +
                 row("peers/quick/open-world/1000/own", 40, R"(, "median": 44, "p99": 50)"));
  EXPECT_THAT(
      cells_markdown(results),
      HasSubstr("| open-world | 1,000 | as the scene moves | 0 | 10.0 µs | 12.0 µs, 31.0 µs | `quick` | "
                "40.0 µs | 44.0 µs, 50.0 µs | 4.0 |  |"));
  EXPECT_THAT(times_csv(results), HasSubstr("open-world,1000,own,quick,4e-05,4.4e-05,5e-05,"));
  EXPECT_THAT(summary_markdown(results), HasSubstr("(open-world, `quick`)"));
}

TEST(PeerChart, OfASceneWithAMotionOfItsOwnHasTwoPanels) {
  const PeerResults results =
      results_of(row("peers/stream/pile/1000/own", 10) + row("peers/stream/pile/1000/initial", 20));
  const auto pile = static_cast<std::size_t>(std::find(kPeerScenes.begin(), kPeerScenes.end(), "pile") -
                                             kPeerScenes.begin());
  const std::string script = chart_script(results, pile);
  EXPECT_THAT(script, HasSubstr("layout 1,3"));
  EXPECT_THAT(script, HasSubstr("set title 'as the scene moves'"));
  EXPECT_THAT(script, HasSubstr("set title 'all new'"));
  EXPECT_THAT(script, Not(HasSubstr("'all move'")));
}

TEST(PeerTables, ShowHowEvenTheFramesAre) {
  EXPECT_EQ(tails_markdown({}), "");
  const std::string name = "p99/stream_1/wall/10000/dyn10";
  EXPECT_THAT(
      tails_markdown(results_of(row(name, 250, R"(, "p99/median": 1.5, "mean/median": 1.1, "frames": 990)"))),
      HasSubstr("| wall, 10,000, 10 % move | 250 µs | 1.1 | 1.5 | 990 |"));
}

TEST(PeerTables, ComeDownToASentence) {
  EXPECT_EQ(
      headline_markdown(results_of(two_cells())),
      "In 2 measured cases the fastest of the others took 6.0 times as long as `stream` (geometric mean);\n"
      "in 2 of them it took at least twice as long.\n");
  EXPECT_EQ(headline_markdown({}), "");
}

// The pages of a project, with marks in the given lines, in a folder of the test's own.
std::filesystem::path project_with(const std::string& readme, const std::string& page) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto project = std::filesystem::path(testing::TempDir()) / ("peers_pages_" + test);
  std::filesystem::remove_all(project);
  std::filesystem::create_directories(project / "docs");
  std::filesystem::create_directories(project / "bench/figures");
  EXPECT_TRUE(report::write_text_file(project / "README.md", readme).ok());
  EXPECT_TRUE(report::write_text_file(project / "docs/peers.md", page).ok());
  EXPECT_TRUE(report::write_text_file(project / "uniform.png", "a chart").ok());
  return project;
}

constexpr const char* kMarks = "before\n<!-- peers: begin -->\nold\n<!-- peers: end -->\nafter\n";

TEST(PeerPages, HoldTheSummaryItsSentenceAndTheChart) {
  const auto project = project_with(kMarks, kMarks);
  const PeerResults results = results_of(two_cells());
  ASSERT_TRUE(update_pages(project, results, project / "uniform.png").ok());
  const auto between_marks = [](const std::string& content) {
    return *replace_between_marks(kMarks, "peers", content);
  };
  EXPECT_EQ(*report::read_text_file(project / "README.md"), between_marks(headline_markdown(results)));
  EXPECT_EQ(*report::read_text_file(project / "docs/peers.md"), between_marks(summary_markdown(results)));
  EXPECT_EQ(*report::read_text_file(project / "bench/figures/peers.png"), "a chart");
}

TEST(PeerPages, StayAsTheyAreWhenOneHasNoMarks) {
  const auto project = project_with("no marks\n", kMarks);
  EXPECT_FALSE(update_pages(project, results_of(two_cells()), project / "uniform.png").ok());
  EXPECT_EQ(*report::read_text_file(project / "docs/peers.md"), kMarks);
}

TEST(PeerChart, DrawsEveryExactPeerOfTheSceneOnce) {
  const std::string script = chart_script(results_of(two_cells()), 0);
  EXPECT_THAT(script, HasSubstr("set terminal pngcairo"));
  EXPECT_THAT(script, HasSubstr("1000 4e-05\n"));  // `quick`, in seconds
  EXPECT_THAT(script, HasSubstr("title 'memory''s limit'"));
  EXPECT_THAT(script, HasSubstr("scene uniform"));
  EXPECT_THAT(script, Not(HasSubstr("title 'stream 1'")));
  EXPECT_THAT(script, Not(HasSubstr("9.0")));  // of scene wall
}

}  // namespace
}  // namespace cellsweep::bench
