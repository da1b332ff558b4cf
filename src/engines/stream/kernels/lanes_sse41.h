/// @file
/// Boxes side by side in vectors of SSE4.1.
#pragma once

#include <smmintrin.h>

#include "engines/stream/kernels/eight.h"

namespace cellsweep::stream {
namespace {

/// Four boxes at a time.
struct Sse41Lanes {
  static constexpr unsigned kCount = 4;
  static constexpr auto kEightBlocks = eight_blocks_in_turn;
  using Vector = __m128;
  using Mask = __m128;

  static void gather(const TaggedBox* boxes, std::uint32_t /*there*/, Vector (&faces)[6]) {
    const auto half_of = [](const TaggedBox& box, std::size_t half) {
      return _mm_load_ps(reinterpret_cast<const float*>(&box) + 4 * half);
    };
    for (std::size_t half = 0; half < 2; ++half) {
      Vector a = half_of(boxes[0], half), b = half_of(boxes[1], half);
      Vector c = half_of(boxes[2], half), d = half_of(boxes[3], half);
      _MM_TRANSPOSE4_PS(a, b, c, d);
      faces[4 * half] = a;
      faces[4 * half + 1] = b;
      if (half == 1) break;  // behind the sixth face lies the tag
      faces[2] = c;
      faces[3] = d;
    }
  }
  static Vector broadcast(const float* from) { return _mm_load1_ps(from); }
  static Mask less_equal(Vector a, Vector b) { return _mm_cmple_ps(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_ps(a, b); }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm_movemask_ps(mask)); }
};

}  // namespace
}  // namespace cellsweep::stream
