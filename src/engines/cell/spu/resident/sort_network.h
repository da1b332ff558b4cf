/// @file
/// A bitonic sorting network on words, four at a time, and the removal of equal neighbours (F2).
#pragma once

#include <spu_intrinsics.h>

#include <cstdint>

namespace cellsweep::cell {

/// Larger than every key; the network moves it to the end.
constexpr int kLastKey = 0x7fffffff;

/// Sorts keys ascending, and values with them. `vectors` is a power of two. The order of equal keys is the
/// same each time but otherwise undefined.
void sort_network(vec_int4* keys, vec_int4* values, unsigned int vectors);

/// Where keys, which must be sorted, agree in their upper halves, keeps the value of the first; drops the
/// values of kLastKey. Returns how many values are left; those behind them are undefined.
unsigned int remove_duplicates(const vec_int4* keys, vec_int4* values, unsigned int vectors);

/// An integer that is ordered as floats are, for any float that is a number and not -0.
inline vec_int4 ordered_bits(vec_float4 value) {
  const vec_int4 bits = (vec_int4)value;
  return spu_xor(bits, spu_and(spu_rlmaska(bits, -31), spu_splats(0x7fffffff)));
}

}  // namespace cellsweep::cell
