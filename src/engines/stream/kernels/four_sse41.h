/// @file
/// Boxes four floats at a time: tests of two, and the small numbers of eight in turn.
#pragma once

#include <smmintrin.h>

#include "engines/stream/kernels/faces.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {
namespace {

/// Minimum x, y, z and something; maximum x, y, z and something.
struct FourFloats {
  __m128 low;
  __m128 high;

  explicit FourFloats(const Aabb& box) : low(_mm_loadu_ps(faces_of(box))) {
    const __m128 last = _mm_loadu_ps(faces_of(box) + 2);
    high = _mm_shuffle_ps(last, last, _MM_SHUFFLE(0, 3, 2, 1));
  }
};

inline bool do_overlap(const FourFloats& a, const FourFloats& b) {
  const __m128 all = _mm_and_ps(_mm_cmple_ps(a.low, b.high), _mm_cmple_ps(b.low, a.high));
  return (_mm_movemask_ps(all) & 7) == 7;
}

/// The numbers of a grid on all axes.
struct FourNumbers {
  __m128 origin;
  __m128 scale;
  __m128 top;

  explicit FourNumbers(const GridNumbers& grid)
      : origin(four(grid.origin)), scale(four(grid.scale)), top(four(grid.top)) {}

  static __m128 four(const float* three) { return _mm_setr_ps(three[0], three[1], three[2], 0); }

  // Where an operand is NaN, the second one is the result.
  __m128i cells(__m128 coordinates) const {
    const __m128 cells = _mm_mul_ps(_mm_sub_ps(coordinates, origin), scale);
    return _mm_cvttps_epi32(_mm_min_ps(_mm_max_ps(cells, _mm_setzero_ps()), top));
  }
};

inline void eight_rows_in_turn(const Aabb* boxes, const GridNumbers& grid, unsigned axis, EightRows& rows) {
  const FourNumbers numbers(grid);
  const unsigned y = (axis + 1) % 3, z = (axis + 2) % 3;
  rows.there = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const FourFloats box(boxes[i]);
    alignas(16) std::uint32_t low[4], high[4];
    _mm_store_si128(reinterpret_cast<__m128i*>(low), numbers.cells(box.low));
    _mm_store_si128(reinterpret_cast<__m128i*>(high), numbers.cells(box.high));
    rows.on_axis[i] = low[axis] | high[axis] << 16;
    rows.on_others[i] = low[y] | high[y] << 8 | low[z] << 16 | high[z] << 24;
    rows.there |= (faces_of(boxes[i])[0] <= faces_of(boxes[i])[3] ? 1U : 0U) << i;
  }
}

}  // namespace
}  // namespace cellsweep::stream
