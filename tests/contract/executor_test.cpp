/// @file
/// Engine `stream` on job systems of the caller's: whatever they do with tasks, the lists are the same.
#include <gmock/gmock.h>

#include <algorithm>
#include <deque>
#include <thread>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/executors.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kBodiesOfExecutors = effort(80, 60, 50);
constexpr int kStepsOfExecutors = effort(12, 6, 3);

Broadphase on(std::shared_ptr<Executor> executor, unsigned threads = kConcurrency) {
  return std::move(*make_broadphase(StreamOptions{.threads = threads, .executor = std::move(executor)}));
}

std::vector<Answer> answers_of(Broadphase engine, const BoxKind& kind) {
  CheckedEngine checked(std::move(engine), story_of(kind, kBodiesOfExecutors, 3));
  RandomCaller caller(checked, kind, kBodiesOfExecutors, 3);
  std::vector<Answer> answers;
  testing::AssertionResult good = caller.fill();
  for (int step = 0; good && step < kStepsOfExecutors; ++step) {
    good = caller.step();
    answers.push_back(checked.answer());
  }
  EXPECT_TRUE(good);
  return answers;
}

using ExecutorContract = testing::TestWithParam<BoxKind>;

TEST_P(ExecutorContract, WhoRunsTasksInWhichOrderChangesNoListAndNoOrder) {
  const BoxKind& kind = GetParam();
  const std::vector<Answer> alone = answers_of(on(nullptr, 1), kind);
  EXPECT_TRUE(answers_of(on(nullptr), kind) == alone) << "threads of the library's own";
  EXPECT_TRUE(answers_of(on(std::make_shared<SequentialExecutor>()), kind) == alone) << "one after the other";
  EXPECT_TRUE(answers_of(on(std::make_shared<ReversingExecutor>()), kind) == alone) << "the last one first";
  EXPECT_TRUE(answers_of(on(std::make_shared<OtherThreadExecutor>()), kind) == alone) << "another thread";
  EXPECT_TRUE(answers_of(on(std::make_shared<ThreadPerTaskExecutor>()), kind) == alone) << "a thread each";
}

INSTANTIATE_TEST_SUITE_P(Stream, ExecutorContract, all_kinds(),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Executors, NeverGetMoreTasksThanTheyTakeOrThanWereAskedFor) {
  for (const unsigned threads : {0U, 1U, 2U, 3U, 8U}) {
    const unsigned most = threads == 0 ? kConcurrency : std::min(threads, kConcurrency);
    const auto executor = std::make_shared<WatchfulExecutor>(most);
    answers_of(on(executor, threads), box_kind("uniform"));
    EXPECT_TRUE(executor->promises_were_kept()) << threads << " threads";
    if (threads > 1) {
      EXPECT_EQ(executor->most_seen(), most) << threads << " threads";
    }
  }
}

TEST(Executors, LiveAsLongAsTheLastBroadphaseThatHasThem) {
  auto executor = std::make_shared<SequentialExecutor>();
  const std::weak_ptr<Executor> watched = executor;
  {
    Broadphase first = on(executor);
    Broadphase second = on(std::move(executor));
    first = Broadphase();
    EXPECT_FALSE(watched.expired());
    second = std::move(first);
    EXPECT_TRUE(watched.expired());
  }
}

TEST(Executors, MayBeSharedByBroadphasesOnSeveralThreads) {
  const BoxKind& kind = box_kind("touching");
  const std::vector<Answer> alone = answers_of(on(nullptr, 1), kind);
  const auto shared = std::make_shared<ThreadPerTaskExecutor>();
  std::vector<std::vector<Answer>> together(3);
  std::deque<std::jthread> threads;
  for (std::vector<Answer>& answers : together) {
    threads.emplace_back([&] { answers = answers_of(on(shared), kind); });
  }
  threads.clear();
  for (const std::vector<Answer>& answers : together) EXPECT_TRUE(answers == alone);
}

}  // namespace
}  // namespace cellsweep::contract
