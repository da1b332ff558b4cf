/// @file
/// Search in a sorted array, a vector at a time (F2; the document's method 1 searches it element by element).
#pragma once

#include "engines/cell/spu/resident/lanes.h"

namespace cellsweep::cell {

/// How many values of the ascending array are less than `value`. The array is `vectors` vectors, filled up
/// with values that are not. The search goes from vector to vector in either direction, beginning at the one
/// that holds element `hint`: searches for neighbours that begin where the last one ended are short (temporal
/// coherence).
inline unsigned int count_less(const vec_float4* sorted, unsigned int vectors, float value,
                               unsigned int hint) {
  const vec_float4 wanted = spu_splats(value);
  unsigned int at = hint / 4;
  while (at < vectors && mask_bits(spu_cmpgt(wanted, sorted[at])) == 15U) ++at;
  unsigned int less = at < vectors ? mask_bits(spu_cmpgt(wanted, sorted[at])) : 0;
  while (less == 0 && at > 0) less = mask_bits(spu_cmpgt(wanted, sorted[--at]));
  return 4 * at + count_bits(less);
}

}  // namespace cellsweep::cell
