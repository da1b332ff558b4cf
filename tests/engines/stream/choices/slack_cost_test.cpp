/// @file
/// When what fat boxes cost, beyond their pairs, is worth making them anew.
#include "engines/stream/choices/slack_cost.h"

#include <gtest/gtest.h>

namespace cellsweep::stream {
namespace {

constexpr std::size_t kInPile = 1000;
constexpr std::size_t kPairs = 3000;

/// Updates until it is high; at most so many.
int updates_until_high(SlackCost& cost, std::size_t candidates, int most) {
  for (int update = 0; update < most; ++update) {
    if (cost.is_high(kInPile, candidates)) return update;
    cost.note(candidates, kPairs);
  }
  return most;
}

TEST(SlackCost, IsNeverHighWhereMostCandidatesArePairs) {
  SlackCost cost;
  EXPECT_EQ(updates_until_high(cost, kPairs + kPairs / 2, 100'000), 100'000);
}

// 7,500 looks in each update for nothing; to make them anew takes as long as 25,000 + 60,000.
TEST(SlackCost, IsHighOnceItHasCostSomeTimesAsMuchAsToMakeThemAnew) {
  SlackCost cost;
  EXPECT_EQ(updates_until_high(cost, 12'000, 1000), 23);
  cost.note_made();
  EXPECT_EQ(updates_until_high(cost, 12'000, 1000), 23) << "it begins anew";
}

TEST(SlackCost, IsHighLessOftenWhereThatIsOfNoUse) {
  SlackCost cost;
  int before = updates_until_high(cost, 12'000, 1000);
  for (int time = 0; time < 5; ++time) {
    cost.note_refit(12'000);
    const int updates = updates_until_high(cost, 12'000, 10'000);
    EXPECT_GE(updates, 2 * before - 1);
    before = updates;
  }
  for (int time = 0; time < 5; ++time) {
    cost.note_refit(12'000);
    EXPECT_LE(updates_until_high(cost, 12'000, 10'000), 23 * 32 + 32) << "and no less than that";
  }
}

TEST(SlackCost, IsHighAsSoonAsBeforeOnceThatWasOfUse) {
  SlackCost cost;
  updates_until_high(cost, 12'000, 1000);
  cost.note_refit(12'000);
  updates_until_high(cost, 12'000, 1000);
  cost.note_refit(12'000);
  for (int update = 0; update < 20; ++update) cost.note(5000, kPairs);
  cost.note_made();
  EXPECT_EQ(updates_until_high(cost, 12'000, 1000), 23);
}

}  // namespace
}  // namespace cellsweep::stream
