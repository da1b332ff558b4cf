#include "contract/faults/failing_calls.h"

#include <atomic>

namespace cellsweep::contract {
namespace {

// Read before main() begins, so nothing here may need construction.
struct Failure {
  std::atomic<std::uint64_t> left{0};  // calls up to the one that fails; 0: none will
  std::atomic<bool> for_ever{false};
  std::atomic<std::uint64_t> failed{0};
  std::atomic<std::uint64_t> counted{0};
};

constinit Failure failures[2];
constinit std::atomic<bool> counts{false};

}  // namespace

void let_fail(Scarce scarce, std::uint64_t n, Lasts lasts) {
  Failure& failure = failures[static_cast<int>(scarce)];
  failure.for_ever = lasts == Lasts::for_ever;
  failure.failed = 0;
  failure.counted = 0;
  failure.left = n;
}

void count_calls(bool on) {
  counts = on;
}

std::uint64_t failed_calls(Scarce scarce) {
  return failures[static_cast<int>(scarce)].failed;
}

std::uint64_t counted_calls(Scarce scarce) {
  return failures[static_cast<int>(scarce)].counted;
}

bool must_fail(Scarce scarce) {
  if (!counts.load(std::memory_order_relaxed)) return false;
  Failure& failure = failures[static_cast<int>(scarce)];
  ++failure.counted;
  std::uint64_t left = failure.left.load();
  while (left > 0) {
    const bool fails = left == 1;
    if (!(fails && failure.for_ever) && !failure.left.compare_exchange_weak(left, left - 1)) continue;
    if (fails) ++failure.failed;
    return fails;
  }
  return false;
}

}  // namespace cellsweep::contract
