/// @file
/// Steps C7 and C8: sorts the four elements of each vector, the IDs following by the same pattern.
#pragma once

#include <cstdint>

#include "engines/cell/spu/paper/tracked.h"

namespace cellsweep::cell::paper {

/// C7, Listings 4.8 and 4.9, on floats: three compare-and-rearrange steps.
/// C8, Listing 4.10: where two compared values are equal, one lane of the two is forced to take the other's
/// place, else the ID of one would come out twice.
void sort_elements(Tracked& tracked);

/// sort_elements() on each of `vectors` vectors.
void intravector_sort(float* values, std::uint32_t* ids, std::uint32_t vectors);

}  // namespace cellsweep::cell::paper
