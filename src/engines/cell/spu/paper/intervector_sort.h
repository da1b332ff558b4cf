/// @file
/// Steps C5 and C6: puts whole vectors into order, the IDs following their values.
#pragma once

#include <cstdint>

#include "engines/cell/spu/paper/tracked.h"

namespace cellsweep::cell::paper {

/// C6, Figure 4.7: in each lane the larger value goes to `high` and the smaller one to `low`; equal values
/// stay.
void split_lanes(Tracked& low, Tracked& high);

/// C5, Figures 4.3 and 4.4: four lane splits with a rotation after each, so that every element of `high` ends
/// at or above every element of `low`.
void split(Tracked& low, Tracked& high);

/// Whether a vector's way down ends at the first neighbour that lies below it, as in the scalar insertion
/// sort (4.1.3), or always at the front. `no` is there to measure what the branch brings.
enum class EarlyOut { no, yes };

/// C5: insertion sort over `vectors` vectors of four. Elements inside a vector come out in any order.
void intervector_sort(float* values, std::uint32_t* ids, std::uint32_t vectors,
                      EarlyOut early_out = EarlyOut::yes);

}  // namespace cellsweep::cell::paper
