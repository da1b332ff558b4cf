/// @file
/// Memory and threads that are not to be had, wherever an engine asks for them: the call changed nothing, and
/// succeeds when it is made again.
#include <gtest/gtest.h>

#include <new>
#include <string>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/faults/starved_call.h"
#include "contract/full_life.h"

namespace cellsweep::contract {
namespace {

/// Few enough for one life for each call that can fail; interpreted SPU programs take long.
std::size_t bodies_of(const ContractEngine& engine) {
  return is_interpreted(engine) ? 16 : 32;
}

/// Where interpreted programs run, faults at a few places show whether those behind the interpreter are told
/// on; the host's are the same as those of other engines.
Places places_of(const ContractEngine& engine) {
  if (is_interpreted(engine)) return {repeated<std::uint64_t>(20, 2), repeated<std::uint64_t>(23, 151)};
  return {repeated<std::uint64_t>(200, effort(60, 40, 40)), repeated<std::uint64_t>(7, effort(23, 41, 101))};
}

class FaultContract : public PerEngine {
 protected:
  void TearDown() override { let_nothing_fail(); }

  static void let_nothing_fail() {
    count_calls(false);
    let_fail(Scarce::memory, 0);
    let_fail(Scarce::threads, 0);
  }

  /// Where Embree and its task library find no memory for themselves they end the program. With sanitizers
  /// only our own calls fail.
  static bool ends_without_memory() { return kPace == Pace::plain && GetParam().name == "embree"; }

  /// True when a call failed.
  static bool live_with(const Fault& fault) {
    CheckedEngine checked(GetParam(), describe(fault));
    checked.surround_calls(count_calls);
    let_fail(fault.scarce, fault.n, fault.lasts);
    full_life(checked, bodies_of(GetParam()));
    let_nothing_fail();
    return checked.failures() > 0;
  }

  /// True when none was made.
  static bool make_with(const Fault& fault) {
    let_fail(fault.scarce, fault.n, fault.lasts);
    count_calls(true);
    bool failed = false;
    try {
      failed = !GetParam().make().ok();
    } catch (const std::bad_alloc&) {
      failed = true;
    }
    let_nothing_fail();
    return failed;
  }

  /// For each of the first n, then for some, until nothing fails any more.
  static void live_with_each(Scarce scarce, Lasts lasts) {
    const Places places = places_of(GetParam());
    std::uint64_t n = 1;
    while (live_with({scarce, n, lasts}) && !HasFailure()) n = places.after(n);
  }
};

TEST_P(FaultContract, ACallThatRunsOutOfMemoryOnceChangesNothingWhereverItHappens) {
  if (ends_without_memory()) return;
  live_with_each(Scarce::memory, Lasts::once);
}

TEST_P(FaultContract, ACallThatRunsOutOfMemoryForGoodChangesNothingWhereverItHappens) {
  if (ends_without_memory()) return;
  live_with_each(Scarce::memory, Lasts::for_ever);
}

TEST_P(FaultContract, ACallThatGetsNoThreadsChangesNothingOrDoesWithout) {
  live_with_each(Scarce::threads, Lasts::once);
  live_with_each(Scarce::threads, Lasts::for_ever);
}

TEST_P(FaultContract, ABroadphaseIsMadeOrIsNot) {
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    for (const Scarce scarce : {Scarce::memory, Scarce::threads}) {
      if (scarce == Scarce::memory && ends_without_memory()) continue;
      std::uint64_t n = 1;
      while (make_with({scarce, n, lasts}) && !HasFailure())
        n = is_interpreted(GetParam()) ? places_of(GetParam()).after(n) : n + 1;
      EXPECT_TRUE(n > 1 || scarce == Scarce::threads) << "nothing was allocated";
      EXPECT_TRUE(GetParam().make().ok());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, FaultContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
