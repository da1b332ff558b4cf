#include "report/run_engine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "cellsweep/engines.h"
#include "fake_frames.h"
#include "report/interrupt.h"

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;

RunReport run_control(const RunSettings& settings) {
  Broadphase engine = std::move(*make_broadphase("control"));
  FakeFrames frames = meeting_cubes();
  return std::move(*run_engine(engine, frames, settings));
}

TEST(RunEngine, ReportsTheFirstAndLastFrameByDefault) {
  const RunReport run = run_control({2, {}});
  ASSERT_EQ(run.frames.size(), 2U);
  EXPECT_EQ(run.frames[0].frame, 0U);
  EXPECT_EQ(run.frames[1].frame, 2U);
}

TEST(RunEngine, ReportsTheFramesAskedForInAscendingOrder) {
  const RunReport run = run_control({2, {2, 1}});
  ASSERT_EQ(run.frames.size(), 2U);
  EXPECT_EQ(run.frames[0].frame, 1U);
  EXPECT_EQ(run.frames[0].pairs, 0U);
  EXPECT_EQ(run.frames[0].hash, 0U);
  EXPECT_EQ(run.frames[1].pairs, 1U);
  EXPECT_EQ(run.frames[1].hash, mix64(1 + 0x9e3779b97f4a7c15ULL));
}

TEST(RunEngine, StopsWhereTheSourceEnds) {
  const RunReport run = run_control({1000, {}});
  EXPECT_EQ(run.update_ms.size(), 2U);
  EXPECT_EQ(run.frames.back().frame, 2U);
}

TEST(RunEngine, RefusesAReportFrameThatIsNotReached) {
  Broadphase engine = std::move(*make_broadphase("control"));
  FakeFrames frames = meeting_cubes();
  const Status status = run_engine(engine, frames, {1000, {3}}).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, HasSubstr("the last frame is 2"));
}

TEST(RunEngine, KeepsSetUpPhasesOutOfTheFrameTimes) {
  Broadphase engine = make_fake({{}, {}, {}});
  FakeFrames frames = meeting_cubes();
  const auto run = run_engine(engine, frames, {2, {}});
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run->setup_ms, 6 * FakeEngine::kSetupMs) << "two phases in each of three frames";
  EXPECT_LT(run->initial_ms, 0);  // the fake claims more set-up time than has passed
}

TEST(RunEngine, RefusesPosesOfASourceThatKnowsNone) {
  FakeFrames frames = meeting_cubes();
  Broadphase engine = make_fake({{}});
  const Status status =
      run_engine(engine, frames, {.updates = 1, .report_frames = {}, .shape = Shape::poses}).status();
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.setting, "spu_boxes");
}

TEST(RunEngine, EndsAfterTheFrameThatItIsAtWhenItIsInterrupted) {
  const InterruptScope interrupts;
  std::raise(SIGINT);
  const RunReport run = run_control({1000, {}});
  EXPECT_EQ(run.update_ms.size(), 0U);
  ASSERT_EQ(run.frames.size(), 1U);
  EXPECT_EQ(run.frames[0].pairs, 1U);
  EXPECT_EQ(run_control({1000, {2}}).frames.size(), 0U) << "a frame that was never reached is no fault then";
}

}  // namespace
}  // namespace cellsweep::report
