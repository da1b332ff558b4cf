#include "report/experiment/experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <string_view>

#include "cellsweep/engines.h"
#include "report/experiment/experiment_run.h"
#include "report/interrupt.h"

namespace cellsweep::report {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ExperimentSettings small_experiment() {
  ExperimentSettings settings;
  settings.bodies = {64, 32, 64};
  settings.frames = 4;
  settings.repetitions = 2;
  settings.simulated_frames = 2;
  return settings;
}

bool is_in_table(std::string_view engine) {
  return std::ranges::any_of(engine_table(), [&](const EngineInfo& info) { return info.name == engine; });
}

bool is_there(const Curve& curve) {
  return make_broadphase(curve.engine, settings_of_engine(curve.part == Part::simulated_cell)).ok();
}

TEST(Experiment, MeasuresEveryEngineThatHasACurveAtEverySize) {
  const auto results = run_experiment(small_experiment());
  ASSERT_TRUE(results.ok()) << results.status().message;
  EXPECT_THAT(results->settings.bodies, ElementsAre(32, 64)) << "ascending, each once";
  EXPECT_THAT(results->wrong, ElementsAre());
  for (const Curve& curve : curve_table()) {
    const bool there = is_there(curve);
    if (!there && is_in_table(curve.engine)) {
      EXPECT_THAT(results->left_out, Contains(HasSubstr(std::string(curve.engine))));
    }
    for (const std::size_t bodies : {32U, 64U}) {
      for (const Measure measure : kAllMeasures) {
        const auto time = results->at(curve.id, bodies, measure);
        ASSERT_EQ(time.has_value(), there) << curve.id;
        // SPEs with nothing to do are not even started.
        const bool may_rest = curve.part == Part::simulated_cell && measure == Measure::still;
        EXPECT_GE(time.value_or(1), may_rest ? 0 : 1e-3) << curve.id << " with " << bodies;
      }
    }
  }
}

TEST(Experiment, KeepsOrderBetweenItsTimes) {
  const auto results = run_experiment(small_experiment());
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
  ExperimentSettings settings = small_experiment();
  settings.bodies = {5000};
  settings.frames = 1;
  settings.repetitions = 1;
  const auto results = run_experiment(settings);
  ASSERT_TRUE(results.ok());
  ASSERT_FALSE(results->left_out.empty());
  EXPECT_THAT(results->left_out[0], HasSubstr("Engine control holds 4096 boxes, not 5000"));
  EXPECT_FALSE(results->at("control", 5000, Measure::initial).has_value());
}

TEST(Experiment, SimulatesACellOnceAndTheSameInEveryRun) {
  const auto one = run_experiment(small_experiment());
  const auto other = run_experiment(small_experiment());
  ASSERT_TRUE(one.ok() && other.ok());
  for (const CurveResult& curve : one->curves) {
    if (curve.curve.part != Part::simulated_cell) continue;
    for (const std::size_t bodies : {32U, 64U}) {
      const double time = one->at(curve.curve.id, bodies, Measure::longest).value();
      EXPECT_EQ(time, other->at(curve.curve.id, bodies, Measure::longest)) << curve.curve.id;
      EXPECT_EQ(time, curve.points.at(bodies)[Measure::longest].highest) << curve.curve.id;
    }
  }
}

TEST(Experiment, LeavesTheSimulatedCellOutWhereItIsNotWantedOrTooLarge) {
  ExperimentSettings settings = small_experiment();
  settings.simulated_most_bodies = 40;
  const auto results = run_experiment(settings);
  ASSERT_TRUE(results.ok());
  if (is_there({.id = "", .label = "", .engine = "cell-paper", .part = Part::simulated_cell, .color = ""})) {
    EXPECT_TRUE(results->at("cell-paper-simulated", 32, Measure::initial).has_value());
    EXPECT_THAT(results->left_out, Contains(HasSubstr("64 boxes: more than 40")));
  }
  EXPECT_FALSE(results->at("cell-paper-simulated", 64, Measure::initial).has_value());

  settings.simulated_frames = 0;
  const auto none = run_experiment(settings);
  ASSERT_TRUE(none.ok());
  EXPECT_FALSE(none->at("cell-paper-simulated", 32, Measure::initial).has_value());
  EXPECT_THAT(none->left_out, ElementsAre());
}

TEST(Experiment, KeepsTheRunsThatWereCompleteWhenItIsInterrupted) {
  const InterruptScope interrupts;
  std::raise(SIGINT);
  const auto results = run_experiment(small_experiment());
  ASSERT_TRUE(results.ok());
  EXPECT_THAT(results->interrupted, HasSubstr("when 0 of "));
  EXPECT_THAT(results->curves, ElementsAre());
  EXPECT_EQ(run_experiment(small_experiment())->interrupted, results->interrupted);
}

TEST(Experiment, SaysNothingOfAnInterruptionThatWasNone) {
  EXPECT_EQ(run_experiment(small_experiment())->interrupted, "");
}

TEST(Experiment, RefusesSettingsThatMeasureNothing) {
  ExperimentSettings settings = small_experiment();
  settings.bodies = {};
  EXPECT_EQ(run_experiment(settings).status().setting, "bodies");
  settings.bodies = {64, 0};
  EXPECT_EQ(run_experiment(settings).status().setting, "bodies");
  settings = small_experiment();
  settings.frames = 0;
  EXPECT_EQ(run_experiment(settings).status().setting, "frames");
  settings = small_experiment();
  settings.repetitions = 0;
  EXPECT_EQ(run_experiment(settings).status().setting, "repetitions");
}

}  // namespace
}  // namespace cellsweep::report
