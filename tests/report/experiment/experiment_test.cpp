#include "report/experiment/experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cellsweep/engines.h"

namespace cellsweep::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ExperimentSettings small() {
  ExperimentSettings settings;
  settings.bodies = {64, 32, 64};
  settings.frames = 4;
  settings.repetitions = 2;
  return settings;
}

TEST(Experiment, MeasuresEveryEngineThatHasACurveAtEverySize) {
  const auto results = run_experiment(small());
  ASSERT_TRUE(results.ok()) << results.status().message;
  EXPECT_THAT(results->settings.bodies, ElementsAre(32, 64)) << "ascending, each once";
  EXPECT_THAT(results->wrong, ElementsAre());
  EXPECT_THAT(results->left_out, ElementsAre());
  for (const Curve& curve : curve_table()) {
    const bool there = make_engine(curve.engine).ok();
    for (const std::size_t bodies : {32U, 64U}) {
      for (const Measure measure : kAllMeasures) {
        const auto time = results->at(curve.id, bodies, measure);
        ASSERT_EQ(time.has_value(), there) << curve.id;
        EXPECT_GT(time.value_or(1), 0) << curve.id << " with " << bodies;
      }
    }
  }
}

TEST(Experiment, KeepsOrderBetweenItsTimes) {
  const auto results = run_experiment(small());
  ASSERT_TRUE(results.ok());
  for (const CurveResult& curve : results->curves) {
    for (const auto& [bodies, times] : curve.points) {
      EXPECT_LE(times[Measure::median].median, times[Measure::longest].median) << curve.curve.id;
      for (const Measure measure : kAllMeasures) {
        EXPECT_LE(times[measure].lowest, times[measure].median);
        EXPECT_LE(times[measure].median, times[measure].highest);
      }
    }
  }
}

TEST(Experiment, LeavesOutWhatAnEngineDoesNotHoldAndSaysSo) {
  ExperimentSettings settings = small();
  settings.bodies = {5000};
  settings.frames = 1;
  settings.repetitions = 1;
  const auto results = run_experiment(settings);
  ASSERT_TRUE(results.ok());
  ASSERT_FALSE(results->left_out.empty());
  EXPECT_THAT(results->left_out[0], HasSubstr("Engine control holds 4096 boxes, not 5000"));
  EXPECT_FALSE(results->at("control", 5000, Measure::initial).has_value());
}

TEST(Experiment, RefusesSettingsThatMeasureNothing) {
  ExperimentSettings settings = small();
  settings.bodies = {};
  EXPECT_EQ(run_experiment(settings).status().setting, "bodies");
  settings.bodies = {64, 0};
  EXPECT_EQ(run_experiment(settings).status().setting, "bodies");
  settings = small();
  settings.frames = 0;
  EXPECT_EQ(run_experiment(settings).status().setting, "frames");
  settings = small();
  settings.repetitions = 0;
  EXPECT_EQ(run_experiment(settings).status().setting, "repetitions");
}

}  // namespace
}  // namespace cellsweep::report
