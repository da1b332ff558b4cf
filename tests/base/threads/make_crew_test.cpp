/// @file
/// Workers that the process keeps for the next who wants them: threads and what was learnt stay, and nothing
/// else.
#include "base/threads/make_crew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "base/threads/thread_pool.h"
#include "base/tuning.h"

#ifdef __linux__
#include <unistd.h>

#include <filesystem>
#endif

namespace cellsweep {
namespace {

using Shared = std::shared_ptr<Crew>;

/// Counts the threads that have done a job here and have ended since.
std::atomic<int> ended = 0;

struct EndOfThread {
  bool was_here = false;
  ~EndOfThread() { ended += was_here ? 1 : 0; }
};

thread_local EndOfThread end_of_thread;

/// Has every worker do a job. Says how many threads but the calling one took part that had done so before.
int work_and_count_known(Crew& crew) {
  std::atomic<int> known = 0;
  const auto caller = std::this_thread::get_id();
  std::atomic<unsigned> here = 0;
  crew.run([&](unsigned) {
    // Until the others have begun: none of them is left to the caller.
    ++here;
    while (here < crew.active()) std::this_thread::yield();
    if (std::this_thread::get_id() == caller) return;
    known += end_of_thread.was_here ? 1 : 0;
    end_of_thread.was_here = true;
  });
  return known;
}

/// Whoever comes next finds no workers but those given up from here on.
void use_up_kept() {
  const Shared one = make_crew(nullptr, 7);
  const Shared other = make_crew(nullptr, 7);
}

TEST(MakeCrew, HasTheWorkersThatWereAskedFor) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    EXPECT_EQ(make_crew(nullptr, threads)->workers(), threads);
    EXPECT_EQ(make_crew(nullptr, threads)->active(), threads);
    EXPECT_EQ(make_crew(nullptr, threads)->choice(), Crew::Choice::given);
  }
  const Shared crew = make_crew(nullptr, 0);
  EXPECT_EQ(crew->workers(), std::min(machine_threads(), tuning::kMostWorkers));
  EXPECT_EQ(crew->choice(), Crew::Choice::by_gain);
}

TEST(MakeCrew, KeepsThreadsForTheNextWhoWantsAsMany) {
  use_up_kept();
  EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 0);
  EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 2);
  const Shared first = make_crew(nullptr, 3);
  const Shared second = make_crew(nullptr, 3);
  EXPECT_EQ(work_and_count_known(*second), 0) << "those of the first are in use";
  EXPECT_EQ(work_and_count_known(*first), 2);
}

TEST(MakeCrew, GivesNobodyOtherWorkersThanWereAskedForAndKeepsThemAllTheSame) {
  use_up_kept();
  EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 0);
  EXPECT_EQ(make_crew(nullptr, 1)->workers(), 1U);
  {
    const Shared other = make_crew(nullptr, 4);
    EXPECT_EQ(other->workers(), 4U);
    EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 2);
  }
  EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 2) << "beside those that were given up later";
  use_up_kept();
  EXPECT_EQ(work_and_count_known(*make_crew(nullptr, 3)), 0) << "only the last two are kept";
}

// As a member is that is made first, and then gets the one it is to have.
TEST(MakeCrew, KeepsThreadsWhereAnotherIsMadeInThePlaceOfOneThatWasNotUsed) {
  use_up_kept();
  int known = 0;
  for (int frame = 0; frame < 10; ++frame) {
    Shared member = make_crew(nullptr, 3);
    member = make_crew(nullptr, 3);
    known += work_and_count_known(*member);
  }
  EXPECT_GE(known, 8 * 2) << "in all frames but the first two";
}

TEST(MakeCrew, EndsTheThreadsOfAllButTwo) {
  use_up_kept();
  std::vector<Shared> crews = {make_crew(nullptr, 2), make_crew(nullptr, 3), make_crew(nullptr, 4)};
  for (const Shared& crew : crews) work_and_count_known(*crew);
  const int before = ended;
  crews[0].reset();
  crews[1].reset();
  EXPECT_EQ(ended, before);
  crews[2].reset();
  EXPECT_EQ(ended, before + 1);
  use_up_kept();
  EXPECT_EQ(ended, before + 1 + 2 + 3);
}

TEST(MakeCrew, UsesAllWorkersAgainAndKnowsWhatWasLearnt) {
  use_up_kept();
  constexpr std::size_t kBoxes = 5000;
  const double guess = make_crew(nullptr, 3)->cost_of_new(kBoxes).seconds();
  {
    const Shared crew = make_crew(nullptr, 3);
    crew->use(1);
    crew->cost_of_new(kBoxes).learn(std::chrono::seconds(1), 1, kBoxes);
  }
  const Shared crew = make_crew(nullptr, 3);
  EXPECT_EQ(crew->active(), 3U);
  EXPECT_GT(crew->cost_of_new(kBoxes).seconds(), guess);
  EXPECT_GT(crew->cost_of_new(kBoxes + 1).seconds(), guess) << "of about as many";
  EXPECT_EQ(crew->cost_of_new(4 * kBoxes).seconds(), guess);
  EXPECT_EQ(crew->cost_of_new(~std::size_t{0}).seconds(), guess);
  EXPECT_EQ(crew->cost_of_new(0).seconds(), guess);
}

TEST(MakeCrew, TakesNoMoreOfAnExecutorThanItHasAndDoesNotHoldItLonger) {
  const auto pool = std::make_shared<ThreadPool>(3);
  EXPECT_EQ(make_crew(pool, 0)->workers(), 3U);
  EXPECT_EQ(make_crew(pool, 2)->workers(), 2U);
  EXPECT_EQ(make_crew(pool, 9)->workers(), 3U);
  EXPECT_EQ(pool.use_count(), 1);
}

TEST(MakeCrew, MayBeAskedFromManyThreadsAtOnce) {
  std::vector<std::thread> threads;
  std::atomic<int> calls = 0;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 100; ++round) make_crew(nullptr, 2)->run([&](unsigned) { ++calls; });
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(calls, 4 * 100 * 2);
}

#if defined(__linux__) && !defined(CELLSWEEP_SANITIZED_TESTS) && !defined(CELLSWEEP_EMULATED_TESTS)

std::ptrdiff_t threads_of_process() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

/// Made before all else, and so destroyed last: an engine that outlives what keeps workers.
struct Late {
  Shared crew;
  bool counts = false;
  ~Late() {
    crew.reset();
    if (counts && threads_of_process() != 1) _exit(3);
  }
};
__attribute__((init_priority(101))) Late destroyed_last;

TEST(MakeCrew, LeavesNoThreadBehindWhenTheProcessEnds) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto end = [] {
    work_and_count_known(*make_crew(nullptr, 3));
    destroyed_last.crew = make_crew(nullptr, 2);
    work_and_count_known(*destroyed_last.crew);
    destroyed_last.counts = true;
    std::exit(0);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(0), "");
}

#endif

}  // namespace
}  // namespace cellsweep
