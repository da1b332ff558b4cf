#include "report/frame_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "fake_frames.h"

namespace cellsweep::report {
namespace {

Status sleep_two_milliseconds() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return {};
}

TEST(FrameClock, TellsTheKindsOfPhasesApart) {
  Broadphase engine = make_fake({{}});
  const auto frame = time_frame(engine, hand_over_nothing);
  ASSERT_TRUE(frame.ok());
  EXPECT_EQ(frame->time.setup_ms, 2 * FakeEngine::kSetupMs);
  EXPECT_EQ(frame->time.spes_ms, FakeEngine::kSpesMs);
  EXPECT_EQ(frame->time.work_ms(), frame->time.total_ms - 2 * FakeEngine::kSetupMs);
  ASSERT_EQ(frame->time.phases.size(), 4U);
  EXPECT_EQ(frame->time.phases[1].name, "work");
}

TEST(FrameClock, RunsWhileBodiesAreHandedOverAndCpuTimeOnlyWhileThereIsWork) {
  Broadphase engine;
  const auto frame = time_frame(engine, sleep_two_milliseconds);
  ASSERT_TRUE(frame.ok());
  EXPECT_GE(frame->time.total_ms, 2);
  EXPECT_LT(frame->time.cpu_ms, frame->time.total_ms);
}

TEST(FrameClock, HandsOutWhatTheUpdateFound) {
  Broadphase engine;
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const auto both = [&] {
    const Status first = engine.insert(1, box);
    return first.ok() ? engine.insert(2, box) : first;
  };
  const auto frame = time_frame(engine, both);
  ASSERT_TRUE(frame.ok());
  ASSERT_EQ(frame->changes.began.size(), 1U);
  EXPECT_EQ(frame->changes.began[0], (Pair{1, 2}));
}

TEST(FrameClock, PassesOnWhatTheHandOverCouldNotDoAndDoesNotUpdate) {
  Broadphase engine;
  const auto frame = time_frame(engine, [&] { return engine.move(7, Aabb{}); });
  EXPECT_EQ(frame.status().code, StatusCode::unknown_body);
  EXPECT_EQ(engine.statistics().updates, 0U);
}

}  // namespace
}  // namespace cellsweep::report
