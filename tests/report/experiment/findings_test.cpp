#include "report/experiment/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "made_up_results.h"

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// By their place in the document.
enum Claim { kInitial, kStatic, kSpus, kFlat, kUpdates };

Finding judged(const ExperimentResults& results, Claim claim) {
  return judge(results)[claim];
}

ExperimentResults with_initial(double cell_64, double x86_64, double cell_1024, double x86_1024) {
  ExperimentResults results = made_up_results();
  set_time(results, "cell-paper", 64, Measure::initial, cell_64);
  set_time(results, "control", 64, Measure::initial, x86_64);
  set_time(results, "cell-paper", 1024, Measure::initial, cell_1024);
  set_time(results, "control", 1024, Measure::initial, x86_1024);
  return results;
}

TEST(InitialFinding, HoldsWhenTheCellVersionLeadsAndTheLeadGrows) {
  const Finding finding = judged(with_initial(100, 120, 20'000, 300'000), kInitial);
  EXPECT_EQ(finding.verdict, Verdict::holds);
  EXPECT_THAT(finding.text, HasSubstr("takes 20.0 ms and control 300 ms: 15.0 times as fast"));
  EXPECT_THAT(finding.text, HasSubstr("with 64 boxes the factor is 1.20"));
  EXPECT_THAT(finding.text, HasSubstr("The lead grows"));
}

TEST(InitialFinding, FailsWhenTheLeadShrinksOrIsTheOthers) {
  EXPECT_EQ(judged(with_initial(100, 300, 200, 400), kInitial).verdict, Verdict::fails);
  const Finding behind = judged(with_initial(100, 20, 400, 200), kInitial);
  EXPECT_EQ(behind.verdict, Verdict::fails);
  EXPECT_THAT(behind.text, HasSubstr("2.00 times as slow"));
}

TEST(StaticFinding, HoldsWhenTheCellVersionLosesAtEverySize) {
  ExperimentResults results = made_up_results();
  for (const std::size_t bodies : results.settings.bodies)
    set_time(results, "control", bodies, Measure::still, 2);
  const Finding finding = judged(results, kStatic);
  EXPECT_EQ(finding.verdict, Verdict::holds);
  EXPECT_THAT(finding.text, HasSubstr("loses at 3 of 3 sizes"));
  EXPECT_THAT(finding.text, HasSubstr("50.0 times as slow"));
}

TEST(StaticFinding, FailsWhenItWinsAtOneSize) {
  ExperimentResults results = made_up_results();
  set_time(results, "control", 64, Measure::still, 2);
  set_time(results, "control", 512, Measure::still, 2);
  set_time(results, "control", 1024, Measure::still, 101);
  const Finding finding = judged(results, kStatic);
  EXPECT_EQ(finding.verdict, Verdict::fails);
  EXPECT_THAT(finding.text, HasSubstr("loses at 2 of 3 sizes"));
  EXPECT_THAT(finding.text, Not(HasSubstr("floor")));
}

TEST(SpuFinding, IsDecidedByTheLongestFrameAtTheLargestSize) {
  ExperimentResults results = made_up_results();
  set_time(results, "control", 1024, Measure::longest, 150);
  EXPECT_EQ(judged(results, kSpus).verdict, Verdict::holds);
  set_time(results, "control", 1024, Measure::longest, 50);
  EXPECT_EQ(judged(results, kSpus).verdict, Verdict::fails);
  set_time(results, "control", 1024, Measure::median, 1e6);
  EXPECT_EQ(judged(results, kSpus).verdict, Verdict::fails) << "the median does not count";
}

TEST(FlatFinding, HoldsUpToAFactorOfOneAndAHalfEitherWay) {
  ExperimentResults results = made_up_results();
  for (const auto& [time, verdict] : {std::pair{149.0, Verdict::holds}, std::pair{151.0, Verdict::fails},
                                      std::pair{68.0, Verdict::holds}, std::pair{65.0, Verdict::fails}}) {
    set_time(results, "cell-paper-spus", 512, Measure::longest, time);
    EXPECT_EQ(judged(results, kFlat).verdict, verdict) << time;
  }
}

ExperimentResults with_updates(double usual, double usual_spus, double longest, double x86) {
  ExperimentResults results = made_up_results();
  set_time(results, "cell-paper", 1024, Measure::median, usual);
  set_time(results, "cell-paper-spus", 1024, Measure::median, usual_spus);
  set_time(results, "cell-paper", 1024, Measure::longest, longest);
  set_time(results, "control", 1024, Measure::longest, x86);
  return results;
}

TEST(UpdatesFinding, HoldsWhenUpdatesAreMostOfTheFrameAndControlIsFaster) {
  ExperimentResults results = with_updates(20'000, 3'000, 40'000, 1'500);
  results.moving_steps[{"cell-paper", 1024}] = {{"spus", 3'000}, {"update pairs", 17'000}};
  const Finding finding = judged(results, kUpdates);
  EXPECT_EQ(finding.verdict, Verdict::holds);
  EXPECT_THAT(finding.text, HasSubstr("85 % are not the SPUs'"));
  EXPECT_THAT(finding.text, HasSubstr("85 % are step “update pairs” and 15 % are step “spus”"));
  EXPECT_THAT(finding.text, HasSubstr("it is not within the 33.3 ms"));
}

TEST(UpdatesFinding, FailsWhenUpdatesAreCheapOrControlIsSlower) {
  EXPECT_EQ(judged(with_updates(20'000, 15'000, 40'000, 1'500), kUpdates).verdict, Verdict::fails);
  const Finding ahead = judged(with_updates(2'000, 300, 4'000, 5'000), kUpdates);
  EXPECT_EQ(ahead.verdict, Verdict::fails);
  EXPECT_THAT(ahead.text, HasSubstr("it is still within"));
}

TEST(Findings, NameTheChapterApartFromTheClaim) {
  for (const Finding& finding : judge(made_up_results())) {
    EXPECT_THAT(finding.chapter, HasSubstr("5."));
    EXPECT_THAT(finding.claim, Not(HasSubstr("(5")));
  }
}

TEST(Findings, AreUnknownWithoutTheCurvesOrSizesTheySpeakOf) {
  ExperimentResults only_control = made_up_results();
  std::erase_if(only_control.curves,
                [](const CurveResult& result) { return result.curve.engine != "control"; });
  for (const Finding& finding : judge(only_control))
    EXPECT_EQ(finding.verdict, Verdict::unknown) << finding.claim;

  ExperimentResults small = made_up_results();
  for (CurveResult& result : small.curves) result.points.erase(1024);
  EXPECT_EQ(judged(small, kUpdates).verdict, Verdict::unknown);
  EXPECT_EQ(judged(small, kFlat).verdict, Verdict::holds);
}

}  // namespace
}  // namespace cellsweep::report
