/// @file
/// From how many there are of each to where they begin.
#pragma once

#include <cstdint>
#include <span>

namespace cellsweep {

/// Each number becomes the sum of those before it. Not inlined, for the size of programs.
[[gnu::noinline]] void make_prefix_sums(std::span<std::uint32_t> counts);

}  // namespace cellsweep
