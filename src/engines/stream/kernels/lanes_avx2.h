/// @file
/// Boxes side by side in vectors of AVX2.
#pragma once

#include <immintrin.h>

#include "engines/stream/kernels/eight_avx2.h"

namespace cellsweep::stream {
namespace {

/// Eight boxes at a time.
struct Avx2Lanes {
  static constexpr unsigned kCount = 8;
  static constexpr auto kEightBlocks = eight_blocks_at_once;
  using Vector = __m256;
  using Mask = __m256;

  static void gather(const TaggedBox* boxes, std::uint32_t /*there*/, Vector (&faces)[6]) {
    gather_eight(&boxes->box, sizeof(TaggedBox), faces);
  }
  static Vector broadcast(const float* from) { return _mm256_broadcast_ss(from); }
  static Mask less_equal(Vector a, Vector b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
  static Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(mask)); }
};

}  // namespace
}  // namespace cellsweep::stream
