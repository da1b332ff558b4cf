/// @file
/// Operator new that fails: for a test program that has failing_new.cpp in it.
#pragma once

#include <cstdint>

namespace cellsweep::contract {

/// The n-th operator new of the calling thread from now on throws, once; none for 0. They count while
/// count_new() is on, which it is not at first.
void let_new_fail(std::uint64_t n);
void count_new(bool on);

}  // namespace cellsweep::contract
