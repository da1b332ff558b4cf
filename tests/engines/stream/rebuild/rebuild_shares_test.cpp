/// @file
/// How the work of a rebuild is shared among updates, as its stages turn out to take.
#include "engines/stream/rebuild/rebuild_shares.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cellsweep::stream {
namespace {

constexpr std::array kStages = {kFatBoxes, kListed, kFilled, kCells, kMended, kCounted, kAll};
using Seconds = std::array<double, kStages.size()>;

void learn(RebuildShares& shares, const Seconds& seconds, int times, std::uint32_t parts = 3) {
  for (int time = 0; time < times; ++time) {
    shares.begin(parts);
    for (std::size_t i = 0; i < kStages.size(); ++i) shares.note(kStages[i], seconds[i]);
    shares.learn();
  }
}

/// What the update with which so much is due does of all stages, in seconds, where `before` was due before.
double seconds_of(const RebuildShares& shares, const Seconds& seconds, double before, double due) {
  double sum = 0;
  for (std::size_t i = 0; i < kStages.size(); ++i)
    sum += (shares.due_of(kStages[i], due) - shares.due_of(kStages[i], before)) * seconds[i];
  return sum;
}

TEST(RebuildShares, MakeEachUpdateDoAsMuch) {
  for (const Seconds& seconds :
       {Seconds{1, 1, 1, 8, 1, 1, 1}, Seconds{4, 1, 2, 14, 3, 2, 3}, Seconds{0.1, 5, 5, 40, 5, 10, 10}}) {
    RebuildShares shares;
    learn(shares, seconds, 50);
    const double all = seconds_of(shares, seconds, 0, 1);
    for (const int updates : {2, 3, 5, 8}) {
      for (int update = 0; update < updates; ++update) {
        const double part = 1.0 / updates;
        EXPECT_NEAR(seconds_of(shares, seconds, update * part, (update + 1) * part) / all, part, 0.02);
      }
    }
  }
}

// Cells take half of all updates nevertheless.
TEST(RebuildShares, MakeEachUpdateOfThreeDoNearlyAsMuchWhereCellsTakeLittle) {
  for (const Seconds& seconds :
       {Seconds{6, 3, 3, 4, 1, 1, 2}, Seconds{3, 1, 2, 3, 1, 1, 1}, Seconds{5, 2, 2, 1, 2, 2, 2}}) {
    RebuildShares shares;
    learn(shares, seconds, 50);
    const double all = seconds_of(shares, seconds, 0, 1);
    for (int update = 0; update < 3; ++update)
      EXPECT_LT(seconds_of(shares, seconds, update / 3.0, (update + 1) / 3.0) / all, 1.3 / 3) << update;
  }
}

TEST(RebuildShares, HaveAllStagesDueInTheirOrderAndInTheEnd) {
  RebuildShares shares;
  for (const Seconds& seconds : {Seconds{}, Seconds{0, 0, 0, 7, 0, 0, 0}, Seconds{0, 0, 0, 0, 0, 7, 7},
                                 Seconds{1e9, 0, 0, 0, 0, 0, 0}, Seconds{1, 2, 3, 4, 5, 6, 7}}) {
    for (std::uint32_t parts = 3; parts < 16; ++parts) {
      learn(shares, seconds, 10, parts);
      for (const RebuildStage stage : kStages) EXPECT_EQ(shares.due_of(stage, 1), 1) << parts;
    }
    learn(shares, seconds, 200);
    for (double due = 0; due <= 1; due += 0.01) {
      for (std::size_t i = 1; i < kStages.size(); ++i) {
        EXPECT_GE(shares.due_of(kStages[i - 1], due), shares.due_of(kStages[i], due));
        if (shares.is_due(kStages[i], due)) {
          EXPECT_TRUE(shares.is_due(kStages[i - 1], due));
        }
      }
    }
    for (const RebuildStage stage : kStages) {
      EXPECT_TRUE(shares.is_due(stage, 1));
      EXPECT_EQ(shares.due_of(stage, 1), 1);
    }
  }
}

TEST(RebuildShares, LeaveNoUpdateWithMostOfTheCellsWhateverTheClockSays) {
  for (const Seconds& seconds :
       {Seconds{1, 1, 1, 0, 1, 1, 1}, Seconds{0, 0, 0, 1, 0, 0, 0}, Seconds{1e9, 0, 0, 0, 0, 0, 0},
        Seconds{1, 0, 0, 0, 0, 0, 1}, Seconds{0, 0, 0, 0, 0, 0, 1e9}}) {
    RebuildShares shares;
    for (const std::uint32_t parts : {3U, 4U, 5U, 7U, 15U}) {
      learn(shares, seconds, 20, parts);
      const double longest = RebuildPace::most_of_part(parts) / parts;
      for (double due = longest; due <= 1; due += 0.01)
        EXPECT_LT(shares.due_of(kCells, due) - shares.due_of(kCells, due - longest), 0.67) << parts;
    }
  }
}

// As where the system took the core away for some milliseconds.
TEST(RebuildShares, AreHardlyMovedByOneStageThatTookVeryLong) {
  constexpr Seconds kUsual = {2, 1, 1, 5, 1, 1, 1};
  constexpr Seconds kOnce = {2, 1000, 1, 5, 1, 1, 1};
  RebuildShares shares;
  learn(shares, kUsual, 50);
  learn(shares, kOnce, 1);
  EXPECT_LT(seconds_of(shares, kUsual, 0, 0.5), 9);
  EXPECT_GT(seconds_of(shares, kUsual, 0, 0.5), 3);
}

TEST(RebuildShares, KnowWhatARebuildTakes) {
  RebuildShares shares;
  EXPECT_EQ(shares.seconds(), 0);
  learn(shares, {2, 1, 1, 5, 1, 1, 1}, 1);
  EXPECT_EQ(shares.seconds(), 12);
  learn(shares, {4, 2, 2, 10, 2, 2, 2}, 50);
  EXPECT_NEAR(shares.seconds(), 24, 0.01);
}

TEST(RebuildShares, ForgetWhatWasGivenUp) {
  constexpr Seconds kUsual = {2, 1, 1, 5, 1, 1, 1};
  RebuildShares shares;
  learn(shares, kUsual, 50);
  shares.begin(3);
  shares.note(kFatBoxes, 1e6);
  learn(shares, kUsual, 1);
  EXPECT_NEAR(seconds_of(shares, kUsual, 0, 0.5), 6, 0.1);
}

}  // namespace
}  // namespace cellsweep::stream
