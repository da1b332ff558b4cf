#include "report/judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;
using Pairs = std::vector<Pair>;

const std::vector<Aabb> kBoxes = {{{0, 0, 0}, {1, 1, 1}}, {{0.5F, 0, 0}, {1.5F, 1, 1}}};
const Pairs kMeet = {{0, 1}};

/// A verdict on what an engine says of frames in which the two boxes meet, part and meet again; what began
/// and ended is said rightly.
VerifyReport verdict_on(const std::vector<Pairs>& said) {
  Judge judge("fake");
  const std::vector<Pairs> truths = {kMeet, {}, kMeet};
  Pairs before;
  for (std::size_t frame = 0; frame < said.size(); ++frame) {
    const bool was = !before.empty();
    const bool is = !said[frame].empty();
    const std::span<const Pair> began =
        is && !was ? std::span<const Pair>(said[frame]) : std::span<const Pair>();
    const std::span<const Pair> ended = was && !is ? std::span<const Pair>(before) : std::span<const Pair>();
    judge.compare(said[frame], {began, ended}, truths[frame], kBoxes);
    before = said[frame];
  }
  return judge.report();
}

TEST(Judge, FindsTheRightPairsExact) {
  const VerifyReport verdict = verdict_on({kMeet, {}, kMeet});
  EXPECT_TRUE(verdict.exact());
  EXPECT_EQ(verdict.engine, "fake");
  EXPECT_EQ(verdict.frames, 3U);
  EXPECT_EQ(verdict.pairs, 2U);
}

TEST(Judge, CountsMissedPairsAndNamesTheFirst) {
  const VerifyReport verdict = verdict_on({{}, {}, {}});
  EXPECT_EQ(verdict.missed, 2U);
  ASSERT_TRUE(verdict.first.has_value());
  EXPECT_EQ(verdict.first->frame, 0U);
  EXPECT_TRUE(verdict.first->missed);
  EXPECT_THAT(describe(*verdict.first), HasSubstr("frame 0: pair 0 1 overlaps but was not reported"));
}

TEST(Judge, CountsInventedPairsEvenOfBodiesThatAreNotThere) {
  const VerifyReport verdict = verdict_on({{{0, 1}, {5, 9}}, kMeet, kMeet});
  EXPECT_EQ(verdict.invented, 2U);
  EXPECT_EQ(verdict.first->pair, (Pair{5, 9}));
}

TEST(Judge, CountsAPairListedTwiceAsInvented) {
  EXPECT_EQ(verdict_on({{{0, 1}, {0, 1}}, {}, kMeet}).invented, 1U);
}

TEST(Judge, TakesPairsInAnyOrder) {
  Judge judge("fake");
  const Pairs all = {{0, 1}, {0, 2}, {1, 2}};
  const Pairs backwards = {{1, 2}, {0, 2}, {0, 1}};
  judge.compare(backwards, {all, {}}, all, kBoxes);
  EXPECT_TRUE(judge.report().exact());
}

TEST(Judge, CountsChangesThatAreNotTheDifferenceOfTheFrames) {
  // The right pairs in every frame, but never a word that any began or ended.
  Judge judge("fake");
  judge.compare(kMeet, {}, kMeet, kBoxes);
  judge.compare({}, {}, {}, kBoxes);
  judge.compare(kMeet, {}, kMeet, kBoxes);
  const VerifyReport& verdict = judge.report();
  EXPECT_EQ(verdict.missed + verdict.invented, 0U);
  EXPECT_EQ(verdict.wrong_changes, 3U);
  EXPECT_FALSE(verdict.exact());
}

}  // namespace
}  // namespace cellsweep::report
