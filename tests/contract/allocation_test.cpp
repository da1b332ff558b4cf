/// @file
/// Operator new that throws, wherever an engine calls it: the call changed nothing, and succeeds when it is
/// made again.
#include <gtest/gtest.h>

#include <new>
#include <string>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/failing_new.h"
#include "contract/full_life.h"

namespace cellsweep::contract {
namespace {

/// Small enough for one life for each allocation.
constexpr std::size_t kBodies = 32;

class AllocationContract : public PerEngine {
 protected:
  void TearDown() override { let_new_fail(0); }

  /// True when memory ran out.
  bool live_with_failure(std::uint64_t n) {
    CheckedEngine checked(GetParam(), "operator new fails the " + std::to_string(n) + "th time");
    checked.may_run_out_of_memory(count_new);
    let_new_fail(n);
    full_life(checked, kBodies);
    let_new_fail(0);
    return checked.failures() > 0;
  }

  /// True when memory ran out.
  bool make_with_failure(std::uint64_t n) {
    let_new_fail(n);
    count_new(true);
    bool failed = false;
    try {
      const Result<Broadphase> made = GetParam().make();
      count_new(false);
      EXPECT_TRUE(made.ok()) << made.status().message;
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    count_new(false);
    let_new_fail(0);
    return failed;
  }
};

TEST_P(AllocationContract, ACallThatRunsOutOfMemoryChangesNothingWhereverItHappens) {
  std::uint64_t n = 1;
  while (live_with_failure(n) && !HasFailure()) n += n < 200 ? 1 : effort(7, 23, 101);
}

TEST_P(AllocationContract, ABroadphaseIsMadeOrIsNot) {
  std::uint64_t n = 1;
  while (make_with_failure(n) && !HasFailure()) ++n;
  EXPECT_GT(n, 1U) << "nothing was allocated";
  EXPECT_TRUE(GetParam().make().ok());
}

/// Those of the core: Embree's own library ends the program where operator new throws, and an SPE's thread
/// may be what finds no memory.
auto engines_of_the_core() {
  std::vector<ContractEngine> engines = contract_engines();
  std::erase_if(engines, [](const ContractEngine& engine) {
    return engine.name == "embree" || engine.name.starts_with("cell-");
  });
  return testing::ValuesIn(engines);
}

INSTANTIATE_TEST_SUITE_P(Engines, AllocationContract, engines_of_the_core(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
