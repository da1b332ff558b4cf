/// @file
/// When fat boxes reach further, and when less far.
#include "engines/stream/choices/growth_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace cellsweep::stream {
namespace {

constexpr std::size_t kInWorld = 1000;

/// An update in which so many fat boxes were put into cells.
FatBoxWork work(std::size_t candidates, std::size_t pairs, std::size_t placed = 0) {
  return {.bodies = kInWorld, .placed = placed, .candidates = candidates, .pairs = pairs};
}

bool is_ample(const GrowthChoice& choice) {
  return choice.growth().least == tuning::kAmpleGrowth;
}
bool is_tight(const GrowthChoice& choice) {
  return choice.growth().most_halvings == tuning::kTightHalvings;
}

/// Updates like this one until it is so; at most so many.
template <class IsSo>
int updates_until(GrowthChoice& choice, const FatBoxWork& each, const IsSo& is_so, int most) {
  for (int update = 0; update < most; ++update) {
    if (is_so(choice)) return update;
    choice.note(each, true);
  }
  return most;
}

TEST(GrowthChoice, IsAmpleOnceCandidatesArePairs) {
  GrowthChoice choice;
  EXPECT_FALSE(is_ample(choice));
  choice.note(work(1125, 1000), true);
  EXPECT_TRUE(is_ample(choice));
  GrowthChoice other;
  other.note(work(1126, 1000), true);
  EXPECT_FALSE(is_ample(other)) << "more than one in eight is none";
}

TEST(GrowthChoice, IsAmpleWhereFewMove) {
  GrowthChoice choice;
  choice.note(work(1000, 1000), false);
  EXPECT_TRUE(is_ample(choice));
}

TEST(GrowthChoice, TakesBackWhatBroughtCandidatesAndTriesItLessSoonAgain) {
  GrowthChoice choice;
  int pause = static_cast<int>(tuning::kPatienceOfGrowth);
  for (int time = 0; time < 12; ++time) {
    choice.note(work(1000, 1000), true);
    ASSERT_TRUE(is_ample(choice)) << time;
    choice.note(work(1200, 1000), true);
    EXPECT_FALSE(is_ample(choice)) << time;
    EXPECT_EQ(updates_until(choice, work(1000, 1000), is_ample, 100'000), pause) << time;
    pause = std::min(2 * pause, static_cast<int>(tuning::kMostPatienceOfGrowth));
  }
}

// To make all anew takes as long as 25,000 looks; 500 of them are usual where there are no pairs.
TEST(GrowthChoice, IsTightOnceCandidatesThatAreNoPairsCostAsMuchAsToMakeAllAnew) {
  GrowthChoice choice;
  EXPECT_EQ(updates_until(choice, work(10'500, 0), is_tight, 100), 3);
  GrowthChoice other;
  EXPECT_EQ(updates_until(other, work(13'500, 1000), is_tight, 100), 3);
}

TEST(GrowthChoice, IsNotTightWhereThereAreThreeCandidatesForEachPair) {
  GrowthChoice choice;
  EXPECT_EQ(updates_until(choice, work(3500, 1000), is_tight, 100'000), 100'000);
}

TEST(GrowthChoice, IsNotTightWhereFatBoxesDoNotLast) {
  GrowthChoice choice;
  EXPECT_EQ(updates_until(choice, work(10'500, 0, 200), is_tight, 10'000), 10'000);
  FatBoxWork all = work(10'500, 0);
  all.is_full = true;
  EXPECT_EQ(updates_until(choice, all, is_tight, 10'000), 10'000);
}

TEST(GrowthChoice, IsNotTightWhereFewMove) {
  GrowthChoice choice;
  for (int update = 0; update < 1000; ++update) choice.note(work(10'500, 0), false);
  EXPECT_FALSE(is_tight(choice)) << "nobody looks at all candidates";
}

TEST(GrowthChoice, IsNotTightForEver) {
  GrowthChoice choice;
  updates_until(choice, work(10'500, 0), is_tight, 100);
  ASSERT_TRUE(is_tight(choice));
  const auto is_not = [](const GrowthChoice& one) { return !is_tight(one); };
  EXPECT_EQ(updates_until(choice, work(1000, 1000), is_not, 1000),
            static_cast<int>(tuning::kPatienceOfGrowth));
}

}  // namespace
}  // namespace cellsweep::stream
