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

  static void gather(const std::byte* boxes, std::size_t step, std::uint32_t /*there*/, Vector (&faces)[6]) {
    stream::gather_eight(reinterpret_cast<const Aabb*>(boxes), step, faces);
  }
  /// Of the numbers whose bits are set, none of them negative, the lane of the least, or of one that is not a
  /// sixteenth larger. Above its lane each has its upper twelve bits behind the sign: there is an instruction
  /// that finds the least of eight such keys.
  static unsigned least(const float (&numbers)[16], std::uint32_t bits) {
    const auto* const from = reinterpret_cast<const __m256i*>(numbers);
    const __m256i low = _mm256_srli_epi32(_mm256_loadu_si256(from), 15);
    const __m256i high = _mm256_srli_epi32(_mm256_loadu_si256(from + 1), 15);
    const __m256i upper = _mm256_and_si256(_mm256_packus_epi32(low, high), _mm256_set1_epi16(-16));
    const __m256i keys = _mm256_or_si256(_mm256_or_si256(upper, packed_lanes()), others(bits));
    const __m128i eight = _mm_min_epu16(_mm256_castsi256_si128(keys), _mm256_extracti128_si256(keys, 1));
    return static_cast<unsigned>(_mm_cvtsi128_si32(_mm_minpos_epu16(eight))) & 15;
  }
  static Doubles doubles(__m128 floats, unsigned) { return _mm256_cvtps_pd(floats); }
  static Doubles roots(Doubles squares) { return _mm256_sqrt_pd(squares); }
  /// 0 in the place of what is less, and of NaN.
  static Vector not_negative(Vector a) { return _mm256_max_ps(a, _mm256_setzero_ps()); }
  static Mask less_equal(Vector a, Vector b) { return _mm256_castps_si256(_mm256_cmp_ps(a, b, _CMP_LE_OQ)); }
  static std::uint32_t bits(Mask mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask)));
  }

 private:
  // In the order in which two vectors are packed into one.
  static __m256i packed_lanes() {
    return _mm256_setr_epi16(0, 1, 2, 3, 8, 9, 10, 11, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  // All bits in lanes whose bit is not set.
  static __m256i others(std::uint32_t bits) {
    const __m256i bit = _mm256_setr_epi16(0x1, 0x2, 0x4, 0x8, 0x100, 0x200, 0x400, 0x800, 0x10, 0x20, 0x40,
                                          0x80, 0x1000, 0x2000, 0x4000, -0x8000);
    const __m256i set = _mm256_and_si256(_mm256_set1_epi16(static_cast<std::int16_t>(bits)), bit);
    return _mm256_cmpeq_epi16(set, _mm256_setzero_si256());
  }
};

}  // namespace
}  // namespace cellsweep::queries
