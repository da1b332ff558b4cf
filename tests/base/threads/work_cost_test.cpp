/// @file
/// What work takes, and by how many workers it takes less.
#include "base/threads/work_cost.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "base/threads/crew.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using std::chrono::microseconds;

constexpr unsigned kWorkers = 4;
constexpr std::size_t kItems = 1000;

/// Does the work as it is to be done, so and so often; returns how often that was by all.
int work(WorkCost& cost, int times, microseconds alone, microseconds by_all) {
  int done_by_all = 0;
  for (int i = 0; i < times; ++i) {
    const bool all = cost.by_all();
    cost.learn(all ? by_all : alone, all ? kWorkers : 1, kItems);
    done_by_all += all ? 1 : 0;
  }
  return done_by_all;
}

TEST(WorkCost, IsAGuessThatEveryWorkCorrects) {
  WorkCost cost(100e-9);
  EXPECT_EQ(cost.seconds(), 100e-9);
  for (int i = 0; i < 50; ++i) cost.learn(microseconds(300), 1, kItems);
  EXPECT_NEAR(cost.seconds(), 300e-9, 1e-9);
  cost.learn(microseconds(1'000'000), 1, kItems);
  EXPECT_LT(cost.seconds(), 400e-9) << "one late thread changes little";
}

TEST(WorkCost, OfOneIsToldByWhatAllTakeUntilOneWasTried) {
  WorkCost cost(100e-9);
  work(cost, static_cast<int>(tuning::kLeastTurns), microseconds(150), microseconds(80));
  EXPECT_GT(cost.seconds(), 151e-9) << "on its way to four of 80";
  work(cost, static_cast<int>(tuning::kTurnsOfTrial), microseconds(150), microseconds(80));
  EXPECT_NEAR(cost.seconds(), 150e-9, 1e-12);
  work(cost, 5, microseconds(150), microseconds(80));
  EXPECT_NEAR(cost.seconds(), 150e-9, 1e-12) << "what all take tells nothing any more";
}

TEST(WorkCost, OneWorkerIsUsedWhereAllTakeLonger) {
  WorkCost cost(100e-9);
  EXPECT_TRUE(cost.by_all());
  work(cost, 100, microseconds(100), microseconds(130));
  EXPECT_LT(work(cost, 10'000, microseconds(100), microseconds(130)), 100) << "and all seldom tried";
}

TEST(WorkCost, AllAreUsedWhereTheyTakeLess) {
  WorkCost cost(100e-9);
  work(cost, 100, microseconds(100), microseconds(60));
  EXPECT_GT(work(cost, 10'000, microseconds(100), microseconds(60)), 9'900) << "and one seldom tried";
}

TEST(WorkCost, OthersAreNotTakenForHardlyAnything) {
  WorkCost cost(100e-9);
  work(cost, 100, microseconds(100), microseconds(98));
  EXPECT_LT(work(cost, 1000, microseconds(100), microseconds(98)), 100);
}

TEST(WorkCost, WhatWasSlowerIsUsedOnceItIsQuicker) {
  WorkCost cost(100e-9);
  for (int world = 0; world < 3; ++world) {
    work(cost, 3000, microseconds(100), microseconds(130));
    EXPECT_LT(work(cost, 500, microseconds(100), microseconds(130)), 20);
    work(cost, 3000, microseconds(100), microseconds(50));
    EXPECT_GT(work(cost, 500, microseconds(100), microseconds(50)), 480);
  }
}

int turns_alone(WorkCost& cost, int times, microseconds alone, microseconds by_all) {
  return times - work(cost, times, alone, by_all);
}

TEST(WorkCost, WhatIsClearlySlowerIsTriedForTwoTurnsAndNotSoonAgain) {
  WorkCost cost(100e-9);
  EXPECT_LE(turns_alone(cost, 40, microseconds(100), microseconds(60)), 4);
  WorkCost other(100e-9);
  EXPECT_LE(work(other, 40, microseconds(60), microseconds(100)), 6);
  WorkCost close(100e-9);
  EXPECT_GT(turns_alone(close, 40, microseconds(100), microseconds(90)), 6) << "where little is lost by it";
}

// The first time threads start, and memory is new.
TEST(WorkCost, TheFirstTurnOfAllDoesNotCount) {
  WorkCost cost(100e-9);
  cost.learn(microseconds(10'000), kWorkers, kItems);
  EXPECT_LE(turns_alone(cost, 40, microseconds(100), microseconds(60)), 4);
}

// What the others of before left in their caches is no reason against a change.
TEST(WorkCost, TheFirstTurnOfATrialDoesNotCount) {
  WorkCost cost(100e-9);
  bool was_by_all = true;
  for (int i = 0; i < 10'000; ++i) {
    const bool all = cost.by_all();
    const bool is_first = all != was_by_all;
    cost.learn(microseconds(is_first ? 400 : (all ? 90 : 70)), all ? kWorkers : 1, kItems);
    was_by_all = all;
  }
  EXPECT_LT(work(cost, 1000, microseconds(70), microseconds(90)), 20);
}

// Not even in a trial, of which there are few turns.
TEST(WorkCost, OneLateThreadChangesLittle) {
  for (int late = 0; late < 40; ++late) {
    WorkCost cost(100e-9);
    for (int turn = 0; turn < 40; ++turn) {
      const bool all = cost.by_all();
      const int usual = all ? 60 : 100;
      cost.learn(microseconds(turn == late ? 1000 * usual : usual), all ? kWorkers : 1, kItems);
    }
    EXPECT_LT(cost.seconds(), 200e-9) << "late in turn " << late;
    work(cost, 100, microseconds(100), microseconds(60));
    EXPECT_GT(work(cost, 1000, microseconds(100), microseconds(60)), 950) << "late in turn " << late;
  }
}

TEST(WorkCost, LearnsNothingFromNothing) {
  WorkCost cost(100e-9);
  work(cost, 20, microseconds(100), microseconds(60));
  const double before = cost.seconds();
  for (int turn = 0; turn < 20; ++turn) cost.learn(microseconds(5), cost.by_all() ? kWorkers : 1, 0);
  EXPECT_EQ(cost.seconds(), before);
  work(cost, 20, microseconds(0), microseconds(0));
  work(cost, 200, microseconds(100), microseconds(60));
  EXPECT_NEAR(cost.seconds(), 100e-9, 5e-9) << "what took less than the clock can tell is not lost for good";
}

TEST(WorkCost, OfACallerWithoutOthersStaysThat) {
  WorkCost cost(100e-9);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(cost.by_all()) << "nothing was tried, so nothing is known of them";
    cost.learn(microseconds(100), 1, kItems);
  }
}

/// Runs tasks one after the other, so that all are never quicker than one.
class InTurn final : public Executor {
 public:
  unsigned concurrency() const override { return kWorkers; }
  void run(unsigned count, Task task, void* context) override {
    for (unsigned i = 0; i < count; ++i) task(context, i);
  }
};

void spend(microseconds time) {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < time) continue;
}

TEST(WorkCost, OneWorkerIsUsedWhereAllTakeTurns) {
  Crew crew(std::make_shared<InTurn>(), kWorkers, Crew::Choice::by_gain);
  WorkCost cost(10e-6);
  int by_all = 0;
  for (int i = 0; i < 120; ++i) {
    const TimedWork work(crew, 100, cost);
    if (crew.active() > 1 && i >= 60) ++by_all;
    crew.run([&](unsigned) { spend(microseconds(500)); });
  }
  EXPECT_LE(by_all, 2 * static_cast<int>(tuning::kTurnsOfTrial));
}

TEST(WorkCost, ANumberOfWorkersThatIsGivenIsUsed) {
  Crew crew(std::make_shared<InTurn>(), kWorkers, Crew::Choice::given);
  WorkCost cost(10e-6);
  work(cost, 100, microseconds(100), microseconds(500));
  ASSERT_FALSE(cost.by_all());
  crew.plan(kItems, cost);
  EXPECT_EQ(crew.active(), kWorkers);
}

// A world that is given again and again as it is takes little; then all of it moves.
TEST(TimedWork, OfManyItemsIsLearntFromThoughEachTookNextToNothingBefore) {
  Crew crew(nullptr, 1, Crew::Choice::by_gain);
  constexpr std::size_t kMany = 50'000;
  WorkCost cost(1e-9);
  ASSERT_LT(kMany * cost.seconds(), tuning::kTooSmall);
  for (int update = 0; update < 10; ++update) {
    const TimedWork work(crew, kMany, cost);
    spend(microseconds(400));
  }
  EXPECT_GT(kMany * cost.seconds(), tuning::kTooSmall);
}

TEST(TimedWork, IsLearntFromWhenItIsWorthTwoLooksAtTheClock) {
  Crew crew(nullptr, 1, Crew::Choice::by_gain);
  const auto items_worth = [](double seconds) { return static_cast<std::size_t>(seconds / 1e-6); };
  WorkCost cost(1e-6);
  {
    const TimedWork work(crew, items_worth(tuning::kTooSmall / 2), cost);
    spend(microseconds(500));
  }
  EXPECT_EQ(cost.seconds(), 1e-6);
  {
    const TimedWork work(crew, items_worth(tuning::kTooSmall * 2), cost);
    spend(microseconds(500));
  }
  EXPECT_GT(cost.seconds(), 1.1e-6);
}

}  // namespace
}  // namespace cellsweep
