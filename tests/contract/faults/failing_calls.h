/// @file
/// Memory and threads that are not to be had, chosen by number: for a test program that has the sources of
/// this folder in it.
#pragma once

#include <cstdint>

namespace cellsweep::contract {

/// What can be made to fail.
enum class Scarce {
  memory,   ///< malloc() and its kin, operator new among them, and mmap()
  threads,  ///< pthread_create()
};

/// How long a failure lasts.
enum class Lasts { once, for_ever };

/// The n-th call from now on fails, in whichever thread; with Lasts::for_ever all behind it, too. None for 0.
/// Calls count while count_calls() is on, which it is not at first.
void let_fail(Scarce scarce, std::uint64_t n, Lasts lasts = Lasts::once);
void count_calls(bool on);

/// How many calls failed, or were made at all and counted, since the last let_fail() for it.
std::uint64_t failed_calls(Scarce scarce);
std::uint64_t counted_calls(Scarce scarce);

/// What the calls ask that stand in for the system's: whether this one fails.
bool must_fail(Scarce scarce);

}  // namespace cellsweep::contract
