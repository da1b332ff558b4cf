/// @file
/// Eight boxes' faces side by side, for kernels with AVX2 or more.
#pragma once

#include <immintrin.h>

#include "engines/stream/kernel.h"

namespace cellsweep::stream {
namespace {

/// The same half of two boxes that are four apart: they become the same lane of two 4 by 4 transpositions.
inline __m256 halves_of(const TaggedBox* boxes, unsigned half) {
  const auto* low = reinterpret_cast<const float*>(boxes) + std::size_t{4} * half;
  const auto* high = reinterpret_cast<const float*>(boxes + 4) + std::size_t{4} * half;
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
}

/// Minimum x, y, z, maximum x, y, z.
inline void gather_eight(const TaggedBox* boxes, __m256 (&faces)[6]) {
  const __m256 a = halves_of(boxes, 0), b = halves_of(boxes + 1, 0);
  const __m256 c = halves_of(boxes + 2, 0), d = halves_of(boxes + 3, 0);
  const __m256 low_ab = _mm256_unpacklo_ps(a, b), high_ab = _mm256_unpackhi_ps(a, b);
  const __m256 low_cd = _mm256_unpacklo_ps(c, d), high_cd = _mm256_unpackhi_ps(c, d);
  faces[0] = _mm256_shuffle_ps(low_ab, low_cd, 0x44);
  faces[1] = _mm256_shuffle_ps(low_ab, low_cd, 0xee);
  faces[2] = _mm256_shuffle_ps(high_ab, high_cd, 0x44);
  faces[3] = _mm256_shuffle_ps(high_ab, high_cd, 0xee);
  const __m256 last_ab = _mm256_unpacklo_ps(halves_of(boxes, 1), halves_of(boxes + 1, 1));
  const __m256 last_cd = _mm256_unpacklo_ps(halves_of(boxes + 2, 1), halves_of(boxes + 3, 1));
  faces[4] = _mm256_shuffle_ps(last_ab, last_cd, 0x44);
  faces[5] = _mm256_shuffle_ps(last_ab, last_cd, 0xee);
}

}  // namespace
}  // namespace cellsweep::stream
