/// @file
/// Sorts keys of pairs whose two numbers have 32 bits together, as they do in most worlds: half the memory,
/// and no pass before the first digit's or after the last one's.
#pragma once

#include <cstdint>

#include "base/memory/array.h"
#include "base/sorting/pair_sort.h"

namespace cellsweep {

/// Writes the numbers of keys, which differ, to `numbers` in ascending order, of each the first one and the
/// second; no first number is less than `least`. False, and nothing is written, when they have more bits, or
/// too many for so few keys: another way is quicker then. `scratch` is working memory, and nothing that is
/// given lies in it. Throws std::bad_alloc.
bool sort_narrow_pairs(KeyParts parts, std::uint32_t least, Array<std::uint64_t>& scratch,
                       std::uint32_t* numbers);

}  // namespace cellsweep
