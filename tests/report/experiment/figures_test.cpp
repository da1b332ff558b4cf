#include "report/experiment/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "made_up_results.h"
#include "report/experiment/figure_csv.h"
#include "report/experiment/figure_plot.h"

namespace cellsweep::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const Figure& figure(std::string_view id) {
  for (const Figure& candidate : figure_table()) {
    if (candidate.id == id) return candidate;
  }
  throw std::runtime_error("no such figure");
}

std::vector<std::string> ids_of(const Figure& figure, const ExperimentResults& results) {
  std::vector<std::string> ids;
  for (const CurveResult* curve : curves_of(figure, results)) ids.emplace_back(curve->curve.id);
  return ids;
}

TEST(Figures, AreThoseOfTheDocumentAndOneMore) {
  std::vector<std::string> redone;
  for (const Figure& one : figure_table()) redone.emplace_back(one.document);
  EXPECT_THAT(redone, ElementsAre("Figure 5.2", "Figure 5.3", "Figure 5.4", "Figure 5.5", ""));
}

TEST(Figures, ShowWholeFramesOrThePartThatTheyAreAbout) {
  const ExperimentResults results = made_up_results();
  EXPECT_THAT(ids_of(figure("initial"), results),
              ElementsAre("control", "cell-paper", "cell-paper-simulated", "cell-brute", "cell-resident",
                          "cell-resident-simulated", "stream", "embree"));
  EXPECT_THAT(ids_of(figure("dynamic-spus"), results),
              ElementsAre("control", "cell-paper-spus", "cell-paper-longest-spu", "cell-paper-simulated"));
  EXPECT_THAT(ids_of(figure("dynamic"), results),
              ElementsAre("control", "cell-paper-spus", "cell-paper", "cell-paper-simulated", "cell-brute",
                          "cell-resident", "cell-resident-simulated", "stream", "embree"));
}

TEST(FigureCsv, HasItsContextInFrontAndARowForEveryPoint) {
  ExperimentResults results = made_up_results();
  results.context.emplace_back("flags", "-O3\n-evil");
  set_time(results, "control", 64, Measure::initial, 123.5);
  const std::string csv = figure_csv(figure("initial"), results);
  EXPECT_THAT(csv, HasSubstr("# cpu: a machine of the mind\n"));
  EXPECT_THAT(csv, HasSubstr("# commit: 0123456789ab\n"));
  EXPECT_THAT(csv, HasSubstr("# flags: -O3 -evil\n"));
  EXPECT_THAT(csv, HasSubstr("# boxes: 64, 512, 1,024\n"));
  EXPECT_THAT(csv, HasSubstr("# units: times in microseconds"));
  EXPECT_THAT(csv, HasSubstr("\nfigure,curve,engine,part,bodies,median_us,lowest_us,highest_us,repetitions\n"
                             "initial,control,control,frame,64,123.5,90,110,3\n"));
  const std::string rows = csv.substr(csv.find("figure,curve"));
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 8 * 3);
}

TEST(FigureScript, NamesItsAxesAndCurvesAndHoldsTheNumbersInSeconds) {
  const std::string script = figure_script(figure("dynamic"), made_up_results());
  EXPECT_THAT(script, HasSubstr("set xlabel 'boxes in the world'"));
  EXPECT_THAT(script, HasSubstr("set ylabel 'longest frame time, logarithmic'"));
  EXPECT_THAT(script, HasSubstr("title 'cell-paper with updates'"));
  EXPECT_THAT(script, HasSubstr("\n64 0.0001 9e-05 0.00011\n"));
  EXPECT_THAT(script, HasSubstr("'1,024' 1024"));
  EXPECT_THAT(script, HasSubstr("set output 'dynamic.svg'"));
  EXPECT_THAT(script, HasSubstr("set output 'dynamic.png'"));
}

TEST(FigureScript, WritesMicrosecondsWithTheirSign) {
  EXPECT_THAT(figure_script(figure("dynamic"), made_up_results()),
              HasSubstr("set encoding utf8\nset micro\n"));
}

}  // namespace
}  // namespace cellsweep::report
