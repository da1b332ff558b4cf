/// @file
/// Memory that runs out, wherever that happens: the call changed nothing, and succeeds when it is made again.
#include <gtest/gtest.h>

#include <string>

#include "base/memory/memory.h"
#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/executors.h"
#include "contract/full_life.h"

namespace cellsweep::contract {
namespace {

/// Every call may throw; how the throwing comes about is arranged elsewhere.
void never_around(bool) {}

/// What an engine does with the memory of base/memory/.
class OutOfMemoryContract : public PerEngine {
 protected:
  void TearDown() override { let_memory_fail(0); }

  /// True when memory ran out.
  bool live_with_failure(std::uint64_t n) {
    CheckedEngine checked(GetParam(), "memory fails the " + std::to_string(n) + "th time");
    checked.surround_calls(never_around);
    let_memory_fail(n);
    full_life(checked, 100);
    let_memory_fail(0);
    return checked.failures() > 0;
  }
};

TEST_P(OutOfMemoryContract, ACallThatRunsOutOfMemoryChangesNothingWhereverItHappens) {
  std::uint64_t n = 1;
  while (live_with_failure(n) && !HasFailure()) n += effort(1, 2, 7);
  EXPECT_GT(n, 10U) << "memory is asked for in fewer places than there are";
}

INSTANTIATE_TEST_SUITE_P(Engines, OutOfMemoryContract, engines_of_the_core(), engine_label);

TEST(StarvedExecutors, ACallThatGetsNoTasksChangesNothing) {
  int failures = 1;
  for (std::uint64_t n = 1; failures > 0 && !testing::Test::HasFailure(); ++n) {
    const auto executor = std::make_shared<StarvedExecutor>(n);
    CheckedEngine checked(
        std::move(*make_broadphase(StreamOptions{.threads = kConcurrency, .executor = executor})),
        "the executor fails the " + std::to_string(n) + "th time");
    checked.surround_calls(never_around);
    full_life(checked, 100);
    failures = checked.failures();
    if (n == 1) {
      EXPECT_EQ(failures, 1) << "no task was ever run";
    }
  }
}

}  // namespace
}  // namespace cellsweep::contract
