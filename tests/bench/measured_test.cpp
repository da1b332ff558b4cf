#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bench/bullet/table/bullet_tables.h"
#include "bench/measured/measured_rows.h"
#include "bench/measured/numbers.h"
#include "bench/measured/page_marks.h"
#include "project_file.h"
#include "report/text_file.h"

namespace cellsweep::bench {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A row as Google Benchmark writes it, of one measurement or of repetitions.
std::string row(const std::string& name, double time, const std::string& more = "",
                const std::string& aggregate = "") {
  const std::string kind = aggregate.empty()
                               ? R"("run_type": "iteration")"
                               : R"("run_type": "aggregate", "aggregate_name": ")" + aggregate + "\"";
  return R"({"run_name": ")" + name + R"(/iterations:1/manual_time", )" + kind +
         R"(, "time_unit": "us", "real_time": )" + std::to_string(time) + more + "},\n";
}

MeasuredRows read(std::string rows) {
  rows.erase(rows.find_last_of(','));
  const auto measured = read_measured_rows(
      R"({"context": {"cpu": "a Cell", "cores": "9", "giant": "last"}, "benchmarks": [)" + rows + "]}");
  EXPECT_TRUE(measured.status().ok());
  return measured ? *measured : MeasuredRows{};
}

TEST(MeasuredRows, HaveTheMedianAndTheSpreadOfRepetitions) {
  const MeasuredRows measured =
      read(row("a/b", 12, R"(, "pairs": 7)", "mean") + row("a/b", 10, R"(, "pairs": 7)", "median") +
           row("a/b", 0.25, "", "cv"));
  ASSERT_EQ(measured.rows.size(), 1U);
  EXPECT_THAT(measured.rows[0].parts, ElementsAre("a", "b", "iterations:1", "manual_time"));
  EXPECT_DOUBLE_EQ(measured.rows[0].seconds, 10e-6);
  EXPECT_DOUBLE_EQ(measured.rows[0].spread, 0.25);
  EXPECT_DOUBLE_EQ(measured.rows[0].counter("pairs"), 7);
  EXPECT_DOUBLE_EQ(measured.rows[0].counter("bytes"), 0);
  EXPECT_THAT(measured.machine, HasSubstr("with a giant (last): a Cell, 9 cores"));
}

TEST(MeasuredRows, PutUpWithTheSpreadOfCountersThatAreZero) {
  const MeasuredRows measured =
      read(row("a", 10, "", "median") +
           row("a", 0.5, ", \"extra\": NaN,\n \"missing\": -NaN,\n \"pairs\": 0", "cv"));
  EXPECT_DOUBLE_EQ(measured.rows.at(0).spread, 0.5);
}

TEST(MeasuredRows, AreTheOneInTheMiddleOfTurnsInTheOrderInWhichNamesCome) {
  const MeasuredRows measured =
      read(row("a", 14, R"(, "p99": 3)") + row("b", 70) + row("c", 1, R"(, "error_occurred": true)") +
           row("a", 10, R"(, "p99": 1)") + row("b", 90) + row("a", 12, R"(, "p99": 2)") + row("b", 80) +
           row("a", 0, R"(, "error_occurred": true)"));
  ASSERT_EQ(measured.rows.size(), 2U);
  EXPECT_DOUBLE_EQ(measured.rows[0].seconds, 12e-6);
  EXPECT_DOUBLE_EQ(measured.rows[0].counter("p99"), 2);
  EXPECT_NEAR(measured.rows[0].spread, 2.0 / 12, 1e-12);
  EXPECT_DOUBLE_EQ(measured.rows[1].seconds, 80e-6);
}

TEST(MeasuredRows, HaveTheMedianInTheMiddleWhereTurnsHadRepetitions) {
  const MeasuredRows measured = read(row("a", 14, "", "median") + row("a", 0.5, "", "cv") +
                                     row("a", 12, "", "median") + row("a", 10, "", "median"));
  EXPECT_DOUBLE_EQ(measured.rows.at(0).seconds, 12e-6);
  EXPECT_NEAR(measured.rows.at(0).spread, 2.0 / 12, 1e-12);
}

TEST(MeasuredRows, AreRepetitionsAloneWhereTheirMedianIsThereToo) {
  const MeasuredRows measured = read(row("a", 14) + row("a", 10) + row("a", 12) + row("a", 12, "", "median"));
  EXPECT_EQ(measured.rows.at(0).turns.size(), 3U);
  EXPECT_DOUBLE_EQ(measured.rows.at(0).seconds, 12e-6);
}

TEST(MeasuredRows, AreComparedTurnByTurn) {
  const std::vector<double> one = {8, 4, 12};
  EXPECT_DOUBLE_EQ(ratio_in_turns(one, std::vector<double>{2, 1, 4}), 4);
  EXPECT_DOUBLE_EQ(ratio_in_turns(one, std::vector<double>{4, 2}), 2);
  EXPECT_THAT(read(row("a", 14) + row("b", 7) + row("a", 12)).rows.at(0).turns,
              ElementsAre(DoubleEq(14e-6), DoubleEq(12e-6)));
}

TEST(MeasuredRows, AreNotReadFromAnythingElse) {
  EXPECT_FALSE(read_measured_rows("peers/stream").status().ok());
  EXPECT_FALSE(read_measured_rows("[]").status().ok());
  EXPECT_FALSE(read_measured_rows("{}").status().ok());
  EXPECT_FALSE(read_measured_rows(R"({"benchmarks": [7]})").status().ok());
  EXPECT_FALSE(read_measured_rows(R"({"benchmarks": [{"run_name": 7}]})").status().ok());
  EXPECT_TRUE(read_measured_rows(R"({"benchmarks": []})")->rows.empty());
}

TEST(MeasuredNumbers, HaveTwoDigitsThatCount) {
  EXPECT_EQ(two_digits(0), "0.00");
  EXPECT_EQ(two_digits(0.874), "0.87");
  EXPECT_EQ(two_digits(0.996), "1.0");
  EXPECT_EQ(two_digits(9.94), "9.9");
  EXPECT_EQ(two_digits(9.96), "10");
  EXPECT_EQ(two_digits(99.4), "99");
  EXPECT_EQ(two_digits(99.6), "100");
  EXPECT_EQ(two_digits(994.9), "990");
  EXPECT_EQ(two_digits(995.1), "1,000");
  EXPECT_EQ(two_digits(1'260), "1,300");
}

TEST(MeasuredNumbers, AreParts) {
  EXPECT_EQ(number_in("1000"), 1000U);
  EXPECT_FALSE(number_in("").has_value());
  EXPECT_FALSE(number_in("10k").has_value());
  EXPECT_FALSE(number_in("-1").has_value());
}

TEST(PageMarks, HoldWhatWasMeasured) {
  const std::string text = "before\n<!-- x: begin -->\nold\n<!-- x: end -->\nafter\n";
  EXPECT_EQ(*replace_between_marks(text, "x", "new\n"),
            "before\n<!-- x: begin -->\nnew\n<!-- x: end -->\nafter\n");
  EXPECT_FALSE(replace_between_marks(text, "y", "new\n").status().ok());
}

TEST(PageMarks, StandInTheProjectsPages) {
  const auto has_marks = [](const std::string& page, const std::string& name) {
    return replace_between_marks(*report::read_text_file(project_file(page)), name, "").status().ok();
  };
  EXPECT_TRUE(has_marks("README.md", "peers"));
  EXPECT_TRUE(has_marks("docs/peers.md", "peers"));
  EXPECT_TRUE(has_marks("docs/query-speed.md", "queries"));
  EXPECT_TRUE(has_marks("docs/query-speed.md", "frames"));
  EXPECT_TRUE(has_marks("docs/bullet.md", "bullet"));
  EXPECT_TRUE(has_marks("docs/bullet.md", "bullet-questions"));
}

MeasuredRows bullet_rows() {
  return read(row("bullet/level/1000/bullet_dbvt", 44, R"(, "p99": 61.5, "frame": 455)") +
              row("bullet/level/1000/stream_1", 11, R"(, "p99": 19, "frame": 417)") +
              row("bullet/level/1000/stream_1_margin", 12, R"(, "p99": 20, "frame": 432)") +
              row("bullet/level/20000/bullet_dbvt", 4040, R"(, "p99": 4960, "frame": 20000)") +
              row("bullet/level/20000/stream_1", 390, R"(, "p99": 510, "frame": 16200)") +
              row("bullet/level/20000/stream_1", 400, R"(, "p99": 510, "frame": 16200)") +
              row("bullet/level/20000/stream_1", 410, R"(, "p99": 510, "frame": 16200)") +
              row("bullet/rays/20000/bullet_dbvt", 10, R"(, "met": 39)") +
              row("bullet/rays/20000/stream_1", 4.2, R"(, "met": 33.2)") +
              row("bullet/boxes/20000/bullet_dbvt", 5.2, R"(, "met": 72)") + row("peers/level/1000/x", 3));
}

TEST(BulletTables, CompareStepsWithThoseOfBulletsTree) {
  const std::string table = bullet_frames(bullet_rows());
  EXPECT_THAT(table, HasSubstr("| level | 1,000 | 44 (62) | 11 (19) | 4.0 | 12 (20) | 3.7 | "
                               "0.455, 0.417, 0.432 |\n"));
  EXPECT_THAT(table, HasSubstr("| level | 20,000 | 4,000 (5,000) | 400 (510) | 10 |  |  | 20.0, 16.2 |\n"));
  EXPECT_THAT(table, HasSubstr("over their mean: 0 % in the middle, 2 % at most (20,000 in level, "
                               "stream_1)."));
  EXPECT_THAT(table, Not(HasSubstr("rays")));
}

TEST(BulletTables, CompareQuestionsThatBothAnswered) {
  const std::string table = bullet_questions(bullet_rows());
  EXPECT_THAT(table, HasSubstr("| rays | 10 | 39 | 4.2 | 33 | 2.4 |\n"));
  EXPECT_THAT(table, Not(HasSubstr("boxes")));
}

}  // namespace
}  // namespace cellsweep::bench
