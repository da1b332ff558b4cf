#include "report/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/engines.h"
#include "cellsweep/world/scene.h"
#include "fake_frames.h"
#include "report/interrupt.h"

namespace cellsweep::report {
namespace {

VerifyReport verdict_on(Broadphase engine) {
  std::vector<FedEngine> engines;
  engines.push_back({std::move(engine), Shape::boxes});
  FakeFrames frames = meeting_cubes();
  return std::move(verify_engines(engines, frames, 100)->front());
}

TEST(Verify, FindsAnExactEngineExact) {
  const VerifyReport verdict = verdict_on(std::move(*make_broadphase("control")));
  EXPECT_TRUE(verdict.exact());
  EXPECT_EQ(verdict.frames, 3U);
  EXPECT_EQ(verdict.pairs, 2U);
}

TEST(Verify, CountsWhatAnEngineMissesAndInvents) {
  EXPECT_EQ(verdict_on(make_fake({{}, {}, {}})).missed, 2U);
  EXPECT_EQ(verdict_on(make_fake({{{0, 1}}, {{0, 1}}, {{0, 1}}})).invented, 1U);
}

TEST(Verify, FindsEnginesExactWhereBodiesComeAndGo) {
  std::vector<FedEngine> engines;
  for (const std::string name : {"stream", "control", "oracle"}) {
    engines.push_back({std::move(*make_broadphase(name)), Shape::boxes});
  }
  const auto frames = std::move(*make_scene_frames({.scene = "open-world", .bodies = 700}));
  const auto verdicts = verify_engines(engines, *frames, 40);
  ASSERT_TRUE(verdicts.ok()) << verdicts.status().message;
  for (const VerifyReport& verdict : *verdicts) EXPECT_TRUE(verdict.exact()) << verdict.engine;
  EXPECT_GT(verdicts->front().pairs, 40U * 100);
}

TEST(Verify, FindsAnEngineInexactThatKeepsThePairsOfBodiesThatWent) {
  std::vector<FedEngine> engines;
  engines.push_back({make_fake({{{0, 1}}, {{0, 1}}}), Shape::boxes});
  LeavingCube frames;
  const auto verdicts = verify_engines(engines, frames, 1);
  ASSERT_TRUE(verdicts.ok()) << verdicts.status().message;
  EXPECT_EQ(verdicts->front().invented, 1U);
}

TEST(Verify, JudgesEnginesSideBySide) {
  std::vector<FedEngine> engines;
  engines.push_back({std::move(*make_broadphase("stream")), Shape::boxes});
  engines.push_back({make_fake({{}, {}, {}}), Shape::boxes});
  FakeFrames frames = meeting_cubes();
  const auto verdicts = verify_engines(engines, frames, 1);
  ASSERT_TRUE(verdicts.ok());
  EXPECT_TRUE((*verdicts)[0].exact());
  EXPECT_FALSE((*verdicts)[1].exact());
  EXPECT_EQ((*verdicts)[1].frames, 2U);
}

TEST(Verify, EndsAfterTheFrameThatItIsAtWhenItIsInterrupted) {
  const InterruptScope interrupts;
  std::raise(SIGINT);
  EXPECT_EQ(verdict_on(Broadphase()).frames, 1U);
}

}  // namespace
}  // namespace cellsweep::report
