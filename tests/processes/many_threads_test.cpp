/// @file
/// Engines in many threads at once, each used by one: they share nothing that they write.
#include <gtest/gtest.h>

#include <latch>
#include <thread>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

constexpr unsigned kThreads = 64;

/// Makes, uses and destroys an engine. The answer is the test's, for its thread.
testing::AssertionResult live(const ContractEngine& engine, unsigned thread) {
  CheckedEngine checked(engine, "one of many threads");
  RandomCaller caller(checked, box_kind("uniform"), 30, thread);
  if (testing::AssertionResult filled = caller.fill(); !filled) return filled;
  for (int step = 0; step < effort(8, 3, 2); ++step) {
    if (testing::AssertionResult right = caller.step(); !right) return right;
  }
  return testing::AssertionSuccess();
}

TEST(ManyThreads, EachHasAnEngineOfItsOwnOfEveryKindInTurn) {
  const std::vector<ContractEngine>& engines = contract_engines();
  std::vector<testing::AssertionResult> results(kThreads, testing::AssertionFailure() << "did not end");
  {
    std::latch begin(kThreads);
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] {
        begin.arrive_and_wait();
        results[i] = live(engines[i % engines.size()], i);
      });
    }
  }
  for (const testing::AssertionResult& result : results) EXPECT_TRUE(result);
}

}  // namespace
}  // namespace cellsweep::contract
