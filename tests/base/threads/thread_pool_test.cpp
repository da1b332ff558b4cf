/// @file
/// The library's own threads: every task once, on as many threads as the system gives.
#include "base/threads/thread_pool.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#ifdef __linux__
#include <pthread.h>
#include <sys/resource.h>
#endif

namespace cellsweep {
namespace {

/// How long tasks take: a thread that has not begun one by the time the others are done comes too late.
enum class Length { short_ones, long_ones };

/// Counts how often each task was run and on which threads.
class Tasks {
 public:
  explicit Tasks(unsigned count, Length length = Length::short_ones) : length_(length), calls_(count) {}

  void run_on(Executor& executor) {
    executor.run(
        static_cast<unsigned>(calls_.size()),
        [](void* tasks, unsigned index) { static_cast<Tasks*>(tasks)->run(index); }, this);
  }
  const std::vector<int>& calls() const { return calls_; }
  const std::set<std::thread::id>& threads() const { return threads_; }

 private:
  void run(unsigned index) {
    ++calls_.at(index);  // without a lock: it must be the only one
    if (length_ == Length::long_ones) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::lock_guard lock(mutex_);
    threads_.insert(std::this_thread::get_id());
  }

  Length length_;
  std::vector<int> calls_;
  std::mutex mutex_;
  std::set<std::thread::id> threads_;
};

void run_and_check(Executor& executor, unsigned count) {
  Tasks tasks(count);
  tasks.run_on(executor);
  ASSERT_THAT(tasks.calls(), testing::Each(1)) << count << " tasks";
  ASSERT_LE(tasks.threads().size(), executor.concurrency());
}

TEST(MachineThreads, AreOneAtLeastAndAlwaysAsMany) {
  EXPECT_GE(machine_threads(), 1U);
  EXPECT_EQ(machine_threads(), machine_threads());
}

TEST(ThreadPool, RunsEveryTaskOnceWhateverTheirNumber) {
  for (const unsigned concurrency : {1U, 2U, 3U, 16U}) {
    ThreadPool pool(concurrency);
    EXPECT_EQ(pool.concurrency(), concurrency);
    for (int round = 0; round < 50; ++round) {
      for (unsigned count = 0; count <= concurrency; ++count) run_and_check(pool, count);
    }
  }
}

TEST(ThreadPool, OfNobodyIsTheCallingThread) {
  ThreadPool pool(0);
  EXPECT_EQ(pool.concurrency(), 1U);
  run_and_check(pool, 1);
}

TEST(ThreadPool, RunsOneTaskAndTheFirstOfSeveralOnTheCallingThread) {
  ThreadPool pool(4);
  for (const unsigned count : {1U, 4U, 1U}) {
    std::vector<std::thread::id> threads(count);
    pool.run(
        count,
        [](void* of, unsigned index) {
          static_cast<std::thread::id*>(of)[index] = std::this_thread::get_id();
        },
        threads.data());
    EXPECT_EQ(threads[0], std::this_thread::get_id());
  }
}

TEST(ThreadPool, KeepsItsThreadsFromOneCallToTheNext) {
  ThreadPool pool(3);
  std::set<std::thread::id> threads;
  for (int round = 0; round < 100; ++round) {
    Tasks tasks(3, Length::long_ones);
    tasks.run_on(pool);
    threads.insert(tasks.threads().begin(), tasks.threads().end());
  }
  EXPECT_EQ(threads.size(), 3U);
}

TEST(ThreadPool, DoesNotWaitForAThreadThatHasNothingToDo) {
  ThreadPool pool(3);
  const auto wait_for_a_late_thread = [](void* of, unsigned index) {
    auto& others = *static_cast<std::atomic<int>*>(of);
    if (index > 0) ++others;
    while (index == 0 && others == 0) std::this_thread::yield();
  };
  for (int round = 0; round < 200; ++round) {
    std::atomic<int> others = 0;
    pool.run(3, wait_for_a_late_thread, &others);
    ASSERT_EQ(others, 2);
    run_and_check(pool, 3);  // which is over before the last thread looks, or is helped by it
  }
}

TEST(ThreadPool, SeesWhatWasWrittenBeforeACallAndShowsWhatItsTasksWrote) {
  ThreadPool pool(4);
  struct Rounds {
    std::vector<int> given;
    std::vector<int> taken;
  } rounds{std::vector<int>(4), std::vector<int>(4)};
  for (int round = 0; round < 500; ++round) {
    for (int& number : rounds.given) number = round;
    pool.run(
        4,
        [](void* of, unsigned index) {
          auto& [given, taken] = *static_cast<Rounds*>(of);
          taken[index] = given[3 - index] + 1;
        },
        &rounds);
    ASSERT_THAT(rounds.taken, testing::Each(round + 1));
  }
}

TEST(ThreadPool, MayBeCalledFromOneThreadAfterTheOther) {
  ThreadPool pool(3);
  for (int round = 0; round < 10; ++round) {
    std::thread([&] { run_and_check(pool, 3); }).join();
    run_and_check(pool, 2);
  }
}

TEST(ThreadPool, EndsItsThreadsWhenItIsDestroyedUsedOrNot) {
  for (int round = 0; round < 50; ++round) {
    const ThreadPool unused(5);
    ThreadPool pool(5);
    run_and_check(pool, 5);
    ThreadPool used_for_one(5);
    run_and_check(used_for_one, 1);
  }
}

TEST(ThreadPool, ItsTasksMayHaveOneOfTheirOwn) {
  ThreadPool outer(2);
  outer.run(
      2,
      [](void*, unsigned) {
        ThreadPool inner(2);
        run_and_check(inner, 2);
      },
      nullptr);
}

#if defined(__linux__) && defined(__GLIBC__)

/// Stacks of new threads have this size, as long as this lives.
class StackSize {
 public:
  explicit StackSize(std::size_t size) {
    pthread_attr_t attributes;
    pthread_getattr_default_np(&attributes);
    pthread_attr_getstacksize(&attributes, &before_);
    pthread_attr_destroy(&attributes);
    set(size);
  }
  StackSize(const StackSize&) = delete;
  StackSize& operator=(const StackSize&) = delete;
  ~StackSize() { set(before_); }

 private:
  static void set(std::size_t size) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    EXPECT_EQ(pthread_attr_setstacksize(&attributes, size), 0);
    EXPECT_EQ(pthread_setattr_default_np(&attributes), 0);
    pthread_attr_destroy(&attributes);
  }

  std::size_t before_ = 0;
};

TEST(ThreadPool, IsTheCallingThreadAloneWhereTheSystemGivesNoThread) {
  const StackSize larger_than_any_address(std::size_t{1} << 60);
  ThreadPool pool(4);
  for (int round = 0; round < 3; ++round) {
    Tasks tasks(4);
    tasks.run_on(pool);
    EXPECT_THAT(tasks.calls(), testing::Each(1));
    EXPECT_EQ(tasks.threads().size(), 1U);
  }
}

TEST(ThreadPool, AsksForThreadsAgainInTheLongRun) {
  ThreadPool pool(4);
  {
    const StackSize larger_than_any_address(std::size_t{1} << 60);
    run_and_check(pool, 4);
  }
  for (int job = 0; job < 1000; ++job) run_and_check(pool, 4);
  Tasks tasks(4, Length::long_ones);
  tasks.run_on(pool);
  EXPECT_THAT(tasks.calls(), testing::Each(1));
  EXPECT_EQ(tasks.threads().size(), 4U);
}

// Sanitizers and emulators need addresses of their own.
#if !defined(CELLSWEEP_SANITIZED_TESTS) && !defined(CELLSWEEP_EMULATED_TESTS)

/// The bytes of addresses that this process has in use.
std::size_t bytes_in_use() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * 4096;
}

TEST(ThreadPool, RunsEveryTaskOnceWhereTheSystemGivesFewerThreadsThanAskedFor) {
  constexpr std::size_t kStack = std::size_t{1} << 30;
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit limit = before;
  limit.rlim_cur = bytes_in_use() + 5 * kStack / 2;
  ThreadPool pool(9);
  {
    const StackSize stack(kStack);
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
    Tasks first(9, Length::long_ones);
    first.run_on(pool);
    ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
    EXPECT_THAT(first.calls(), testing::Each(1));
    EXPECT_GE(first.threads().size(), 2U);
    EXPECT_LT(first.threads().size(), 9U);
  }
  for (unsigned count = 0; count <= 9; ++count) run_and_check(pool, count);
}

#endif
#endif

}  // namespace
}  // namespace cellsweep
