/// @file
/// Step C10: the changed IDs, gathered at the front, each once.
#pragma once

#include <cstdint>

namespace cellsweep::cell::paper {

/// C10: quicksort in descending signed order, so that kUnchanged (−1) goes last: 030434010 becomes 443310000.
void reverse_quicksort(std::int32_t* words, std::uint32_t count);

/// C10: removes repeated neighbours and the sentinel that ends the list: 443310000 becomes 431 (the
/// document's 4310 shows the sentinel). Returns how many are left.
std::uint32_t remove_duplicates(std::int32_t* words, std::uint32_t count, std::int32_t sentinel);

}  // namespace cellsweep::cell::paper
