#include "report/verify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cellsweep/engines.h"
#include "fake_frames.h"

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;

VerifyReport verdict_on(std::unique_ptr<Broadphase> engine) {
  std::vector<std::unique_ptr<Broadphase>> engines;
  engines.push_back(std::move(engine));
  FakeFrames frames = meeting_cubes();
  return std::move(verify_engines(engines, frames, 100)->front());
}

VerifyReport verdict_on_answers(std::vector<std::vector<Pair>> answers) {
  return verdict_on(std::make_unique<FakeEngine>(std::move(answers)));
}

TEST(Verify, FindsAnExactEngineExact) {
  const VerifyReport verdict = verdict_on(std::move(*make_engine("control")));
  EXPECT_TRUE(verdict.exact());
  EXPECT_EQ(verdict.frames, 3U);
  EXPECT_EQ(verdict.pairs, 2U);
}

TEST(Verify, CountsMissedPairsAndNamesTheFirst) {
  const VerifyReport verdict = verdict_on_answers({{}, {}, {}});
  EXPECT_EQ(verdict.missed, 2U);
  ASSERT_TRUE(verdict.first.has_value());
  EXPECT_EQ(verdict.first->frame, 0U);
  EXPECT_TRUE(verdict.first->missed);
  EXPECT_THAT(describe(*verdict.first), HasSubstr("frame 0: pair 0 1 overlaps but was not reported"));
}

TEST(Verify, CountsInventedPairsEvenOfBodiesThatAreNotThere) {
  const VerifyReport verdict = verdict_on_answers({{{0, 1}, {5, 9}}, {{0, 1}}, {{0, 1}}});
  EXPECT_EQ(verdict.invented, 2U);
  EXPECT_EQ(verdict.first->pair, (Pair{5, 9}));
}

TEST(Verify, CountsAPairListedTwiceAsInvented) {
  EXPECT_EQ(verdict_on_answers({{{0, 1}, {0, 1}}, {}, {{0, 1}}}).invented, 1U);
}

TEST(Verify, CountsChangesThatAreNotTheDifferenceOfTheFrames) {
  // The right pairs in every frame, but never a word that any began or ended.
  const VerifyReport verdict = verdict_on_answers({{{0, 1}}, {}, {{0, 1}}});
  EXPECT_EQ(verdict.missed + verdict.invented, 0U);
  EXPECT_EQ(verdict.wrong_changes, 3U);
  EXPECT_FALSE(verdict.exact());
}

}  // namespace
}  // namespace cellsweep::report
