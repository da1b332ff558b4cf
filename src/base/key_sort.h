/// @file
/// Sorts numbers that may lie anywhere.
#pragma once

#include <cstdint>
#include <span>

namespace cellsweep {

/// Ascending. A bucket for each, more or less: most buckets get one or two, unless the numbers crowd
/// together; those that get many are compared. Throws std::bad_alloc and has done nothing then.
void sort_keys(std::span<std::uint64_t> keys);

}  // namespace cellsweep
