/// @file
/// Sorts pair keys by distribution: the first body's id chooses the place, few comparisons are left.
#pragma once

#include <cstdint>
#include <span>

#include "engines/stream/pairs/pair_list.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// Writes all keys of `parts`, which differ, to `sorted` in ascending order. `scratch` is working memory.
void sort_pairs(Pool& pool, std::span<Keys* const> parts, Array<std::uint64_t>& scratch, Array<Pair>& sorted);

}  // namespace cellsweep::stream
