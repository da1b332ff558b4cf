/// @file
/// Boxes side by side with AVX2.
#pragma once

#include <immintrin.h>

#include "engines/stream/kernels/eight_avx2.h"
#include "queries/kernels/body.h"

namespace cellsweep::queries {
namespace {

/// Eight boxes at a time.
struct Avx2QueryLanes : LanesInOrder<8> {
  using Vector = __m256;
  using Mask = __m256i;
  using Doubles = __m256d;

  static void gather(const std::byte* boxes, std::size_t step, Vector (&faces)[6]) {
    stream::gather_eight(reinterpret_cast<const Aabb*>(boxes), step, faces);
  }
  static Doubles doubles(__m128 floats, unsigned) { return _mm256_cvtps_pd(floats); }
  static Doubles roots(Doubles squares) { return _mm256_sqrt_pd(squares); }
  static Mask less_equal(Vector a, Vector b) { return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_LE_OQ)); }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask)));
  }
};

}  // namespace
}  // namespace cellsweep::queries
