/// @file
/// When the cells are asked for the pairs of each body that changed.
#include "engines/stream/pairs/few_choice.h"

#include <gtest/gtest.h>

namespace cellsweep::stream {
namespace {

constexpr std::size_t kCandidates = 100 * tuning::kCandidatesOfQuery;

/// How many updates like this one in a row are of few; at most 1,000.
int updates_of_few(FewChoice& choice, std::size_t changed, bool waits) {
  int updates = 0;
  while (updates < 1000 && choice.choose_few(changed, kCandidates, waits)) ++updates;
  return updates;
}

TEST(FewChoice, IsForWhatTakesLessThanAWalk) {
  FewChoice choice;
  EXPECT_TRUE(choice.choose_few(99, kCandidates, false));
  EXPECT_FALSE(choice.choose_few(100, kCandidates, false));
  EXPECT_FALSE(choice.choose_few(101, kCandidates, false));
  EXPECT_EQ(updates_of_few(choice, 99, true), 1000);
  EXPECT_FALSE(choice.choose_few(0, 0, true)) << "there is nothing to walk";
}

TEST(FewChoice, GoesOnWhereSomethingWaitsUntilThatWouldHavePaid) {
  FewChoice choice;
  EXPECT_EQ(updates_of_few(choice, 150, true), static_cast<int>(2 * tuning::kWalksOfWaiting));
  EXPECT_EQ(updates_of_few(choice, 125, true), static_cast<int>(4 * tuning::kWalksOfWaiting))
      << "it begins anew when all was walked";
  EXPECT_EQ(updates_of_few(choice, 199, true), static_cast<int>(tuning::kWalksOfWaiting));
  EXPECT_FALSE(choice.choose_few(200, kCandidates, true)) << "two walks at once";
}

TEST(FewChoice, CountsWhatWasSavedMeanwhile) {
  FewChoice choice;
  for (int update = 0; update < 1000; ++update)
    ASSERT_TRUE(choice.choose_few(update % 2 == 0 ? 150 : 50, kCandidates, true)) << update;
  // But no more than was lost.
  for (int update = 0; update < 1000; ++update) ASSERT_TRUE(choice.choose_few(1, kCandidates, true));
  EXPECT_EQ(updates_of_few(choice, 150, true), static_cast<int>(2 * tuning::kWalksOfWaiting));
}

}  // namespace
}  // namespace cellsweep::stream
