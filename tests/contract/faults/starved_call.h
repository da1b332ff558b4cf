/// @file
/// One call that does not get the memory or the threads that it asks for: at the first place, at the second,
/// and so on.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <string>

#include "cellsweep/status.h"
#include "contract/faults/failing_calls.h"

namespace cellsweep::contract {

struct Fault {
  Scarce scarce;
  std::uint64_t n;
  Lasts lasts;
};

inline std::string describe(const Fault& fault) {
  return std::string(fault.scarce == Scarce::memory ? "memory" : "threads") + " from the " +
         std::to_string(fault.n) + "th call" + (fault.lasts == Lasts::once ? ", once" : " on");
}

/// Whether a call that returns a Status gets all that it asks for; it must not be refused for anything else.
template <class Call>
bool gets_all(const Call& call) {
  try {
    const Status status = call();
    EXPECT_TRUE(status.ok()) << status.message;
    return status.ok();
  } catch (const std::bad_alloc&) {
    return false;
  }
}

/// The same with a fault; `failed` says whether that happened.
template <class Call>
bool gets_all_with(const Fault& fault, const Call& call, bool& failed) {
  let_fail(fault.scarce, fault.n, fault.lasts);
  count_calls(true);
  const bool got_all = gets_all(call);
  count_calls(false);
  failed = failed_calls(fault.scarce) > 0;
  let_fail(fault.scarce, 0);
  return got_all;
}

/// Which of the places fail: all of the first so many, then one in so many.
struct Places {
  std::uint64_t each_of_first = 1000;
  std::uint64_t then_one_in = 7;

  std::uint64_t after(std::uint64_t n) const { return n + (n < each_of_first ? 1 : then_one_in); }
};

/// For each place where `call()`, which returns a Status, asks for something: calls `begin()`, then `call()`
/// with a fault there, and where that throws std::bad_alloc once more. `look(succeeded)` says after each
/// whether all is as it should be; a call may also do without. Returns at how many places there were faults.
template <class Begin, class Call, class Look>
std::uint64_t starve_each(Scarce scarce, Lasts lasts, const Begin& begin, const Call& call, const Look& look,
                          const Places& places = {}) {
  std::uint64_t faults = 0;
  for (Fault fault{scarce, 1, lasts};; fault.n = places.after(fault.n)) {
    begin();
    bool failed = false;
    const bool succeeded = gets_all_with(fault, call, failed);
    EXPECT_TRUE(look(succeeded)) << describe(fault);
    if (!succeeded) {
      EXPECT_TRUE(failed) << describe(fault) << ": the memory was there";
      EXPECT_TRUE(gets_all(call)) << describe(fault) << ", then once more";
      EXPECT_TRUE(look(true)) << describe(fault) << ", then once more";
    }
    if (!failed || testing::Test::HasFailure()) return faults;
    ++faults;
  }
}

}  // namespace cellsweep::contract
