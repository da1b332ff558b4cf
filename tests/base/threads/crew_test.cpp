/// @file
/// Workers with numbers: who runs which part of a job, what is thrown, and how many workers pay.
#include "base/threads/crew.h"

#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <chrono>
#include <new>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/threads/thread_pool.h"

namespace cellsweep {
namespace {

Crew crew_of(unsigned workers, Crew::Choice choice = Crew::Choice::given) {
  return {std::make_shared<ThreadPool>(workers), workers, choice};
}

/// Runs tasks one after the other, counts how often it is asked to, and fails when it is told to.
class CountingExecutor final : public Executor {
 public:
  unsigned concurrency() const override { return 4; }
  void run(unsigned count, Task task, void* context) override {
    ++runs;
    if (fails) throw std::bad_alloc();
    for (unsigned i = 0; i < count; ++i) task(context, i);
  }

  int runs = 0;
  bool fails = false;
};

TEST(Crew, CallsEveryWorkerOnceAJob) {
  for (const unsigned workers : {1U, 2U, 3U, 16U}) {
    Crew crew = crew_of(workers);
    std::vector<int> calls(workers, 0);
    for (int job = 0; job < 200; ++job) crew.run([&](unsigned worker) { ++calls[worker]; });
    EXPECT_THAT(calls, testing::Each(200)) << workers << " workers";
  }
}

TEST(Crew, LeavesOutWorkersThatAreNotInUse) {
  Crew crew = crew_of(4);
  std::array<int, 4> calls{};
  for (const unsigned used : {2U, 4U, 1U, 9U, 0U}) {
    crew.use(used);
    crew.run([&](unsigned worker) { ++calls[worker]; });
  }
  EXPECT_THAT(calls, testing::ElementsAre(5, 3, 2, 2));
}

TEST(Crew, VisitsEveryIndexOnce) {
  for (const unsigned workers : {1U, 3U}) {
    Crew crew = crew_of(workers);
    for (const std::size_t count : {0, 1, 7, 8, 1000}) {
      for (const std::size_t chunk : {1, 8, 5000}) {
        std::vector<int> visits(count, 0);
        std::atomic<bool> known = true;
        crew.for_each(count, chunk, [&](unsigned worker, std::size_t index) {
          ++visits[index];
          if (worker >= workers) known = false;
        });
        EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), std::size_t{0}), count);
        EXPECT_THAT(visits, testing::Each(1));
        EXPECT_TRUE(known);
      }
    }
  }
}

TEST(Crew, OfOneNeedsNoExecutor) {
  Crew crew(nullptr, 1, Crew::Choice::by_gain);
  crew.plan(1'000'000'000, 1);
  EXPECT_EQ(crew.active(), 1U);
  int calls = 0;
  crew.run([&](unsigned worker) { calls += worker == 0 ? 1 : 100; });
  crew.for_each(5, 2, [&](unsigned, std::size_t) { ++calls; });
  EXPECT_EQ(calls, 6);
}

TEST(Crew, HandsOnWhatAJobThrewAndGoesOn) {
  Crew crew = crew_of(3);
  for (const unsigned thrower : {0U, 2U}) {
    const auto job = [&](unsigned worker) {
      if (worker == thrower) throw std::runtime_error("thrown by a job");
    };
    EXPECT_THROW(crew.run(job), std::runtime_error);
    int calls = 0;
    crew.run([&](unsigned worker) {
      if (worker == 0) ++calls;
    });
    EXPECT_EQ(calls, 1);
  }
}

TEST(Crew, HandsOnOneOfSeveralErrorsAndForgetsTheOthers) {
  for (const unsigned workers : {1U, 4U}) {
    Crew crew = crew_of(workers);
    EXPECT_THROW(crew.run([](unsigned worker) { throw worker; }), unsigned);
    EXPECT_THROW(crew.for_each(100, 3, [](unsigned, std::size_t index) { throw index; }), std::size_t);
    EXPECT_NO_THROW(crew.run([](unsigned) {}));
  }
}

TEST(Crew, HandsOnWhatAnExecutorThrewAndGoesOn) {
  const auto executor = std::make_shared<CountingExecutor>();
  Crew crew(executor, 4, Crew::Choice::given);
  int calls = 0;
  const auto job = [&](unsigned) { ++calls; };
  executor->fails = true;
  EXPECT_THROW(crew.run(job), std::bad_alloc);
  EXPECT_EQ(calls, 0);
  executor->fails = false;
  crew.run(job);
  EXPECT_EQ(calls, 4);
}

TEST(Crew, OfAGivenSizeWorksAsSoonAsEachHasALittleToDo) {
  Crew crew = crew_of(3);
  EXPECT_EQ(crew.workers(), 3U);
  EXPECT_EQ(crew.active(), 3U);
  for (const auto& [items, active] : {std::pair{0U, 1U}, {3U, 1U}, {47U, 1U}, {48U, 3U}, {1'000'000U, 3U}}) {
    crew.plan(items, 1e-12);
    EXPECT_EQ(crew.active(), active) << items << " items";
  }
}

TEST(CrewByGain, AsksItsExecutorForNothingWhileThereIsLittleToDo) {
  const auto executor = std::make_shared<CountingExecutor>();
  Crew crew(executor, 4, Crew::Choice::by_gain);
  for (int update = 0; update < 1000; ++update) {
    crew.plan(1000, 1e-9);
    EXPECT_EQ(crew.active(), 1U);
    crew.run([](unsigned) {});
  }
  EXPECT_EQ(executor->runs, 0);
}

TEST(CrewByGain, StartsWhenItWouldHaveSavedWhatStartingTakes) {
  const auto executor = std::make_shared<CountingExecutor>();
  Crew crew(executor, 4, Crew::Choice::by_gain);
  // Four would save three quarters of 120 microseconds each time.
  for (int update = 0; update < 3; ++update) {
    crew.plan(1, 120e-6);
    EXPECT_EQ(crew.active(), 1U);
    EXPECT_EQ(executor->runs, 0);
  }
  crew.plan(1, 120e-6);
  EXPECT_GT(executor->runs, 0) << "what a dispatch takes is measured";
  const int runs = executor->runs;
  crew.plan(1, 1000);
  EXPECT_EQ(crew.active(), 4U);
  EXPECT_EQ(executor->runs, runs) << "and measured once";
  crew.plan(1, 1e-6);
  EXPECT_EQ(crew.active(), 1U);
}

/// Is late at first, as on a machine that is busy with something else.
class LateExecutor final : public Executor {
 public:
  unsigned concurrency() const override { return 4; }
  void run(unsigned count, Task task, void* context) override {
    if (is_late) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    for (unsigned i = 0; i < count; ++i) task(context, i);
  }

  bool is_late = true;
};

TEST(CrewByGain, MeasuresAgainWhatADispatchTakesThatWasMeasuredAtABadMoment) {
  const auto executor = std::make_shared<LateExecutor>();
  Crew crew(executor, 4, Crew::Choice::by_gain);
  crew.plan(1, 1e-3);
  EXPECT_EQ(crew.active(), 1U) << "what two milliseconds are lost for";
  executor->is_late = false;
  for (int update = 0; update < 100 && crew.active() == 1; ++update) crew.plan(1, 10e-3);
  EXPECT_EQ(crew.active(), 4U);
}

TEST(Share, CutsAListWithoutGapOrOverlap) {
  for (const std::size_t count : {0, 1, 5, 100}) {
    std::size_t next = 0;
    for (unsigned worker = 0; worker < 7; ++worker) {
      const Share share = Share::of(count, worker, 7);
      EXPECT_EQ(share.first, next);
      EXPECT_LE(share.last - share.first, count / 7 + 1);
      next = share.last;
    }
    EXPECT_EQ(next, count);
  }
}

}  // namespace
}  // namespace cellsweep
