/// @file
/// Runs out of memory at every place where a call asks for some.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <new>

#include "base/memory/memory.h"

namespace cellsweep {

/// Memory fails the n-th time that it is asked for, as long as this lives.
class FailingMemory {
 public:
  explicit FailingMemory(std::uint64_t n) { let_memory_fail(n); }
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;
  ~FailingMemory() { let_memory_fail(0); }
};

/// True when the call runs out of memory at the n-th place.
template <class Call>
bool fails_at(std::uint64_t n, const Call& call) {
  const FailingMemory memory(n);
  try {
    call();
  } catch (const std::bad_alloc&) {
    return true;
  }
  return false;
}

/// For each place where `call(state)` asks for memory: makes a state, lets the call fail there, looks with
/// `is_kept(state)` whether nothing that shows has changed, makes the call again, which succeeds, and looks
/// at the end with `is_done(state)`. Returns how many places there are.
template <class Make, class Call, class IsKept, class IsDone>
std::uint64_t starve(const Make& make, const Call& call, const IsKept& is_kept, const IsDone& is_done) {
  for (std::uint64_t n = 1;; ++n) {
    auto state = make();
    const bool failed = fails_at(n, [&] { call(state); });
    if (failed) {
      is_kept(state);
      call(state);
    }
    is_done(state);
    if (!failed || testing::Test::HasFailure()) return n - 1;
  }
}

}  // namespace cellsweep
