/// @file
/// Boxes side by side in vectors of AVX-512.
#pragma once

#include <immintrin.h>

#include "engines/stream/kernels/eight_avx2.h"

namespace cellsweep::stream {
namespace {

/// Sixteen boxes at a time.
struct Avx512Lanes {
  static constexpr unsigned kCount = 16;
  static constexpr auto kEightBlocks = eight_blocks_at_once;
  using Vector = __m512;
  using Mask = __mmask16;

  static void gather(const TaggedBox* boxes, std::uint32_t there, Vector (&faces)[6]) {
    const TaggedBox* const others = boxes + (there > 8 ? 8 : 0);
    __m256 low[6];
    __m256 high[6];
    gather_eight(&boxes->box, sizeof(TaggedBox), low);
    gather_eight(&others->box, sizeof(TaggedBox), high);
    for (unsigned face = 0; face < 6; ++face) {
      faces[face] = __builtin_shufflevector(low[face], high[face], 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
                                            13, 14, 15);
    }
  }
  static Vector broadcast(const float* from) { return _mm512_set1_ps(*from); }
  static Mask less_equal(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static std::uint32_t bits(Mask mask) { return mask; }
};

}  // namespace
}  // namespace cellsweep::stream
