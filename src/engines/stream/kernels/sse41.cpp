#include <smmintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_sse41.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Sixteen boxes of four bytes at a time.
struct Sse41FourBytes {
  static constexpr unsigned kBoxes = 16;
  using Vector = __m128i;

  static Vector broadcast(__m128i bytes) { return _mm_shuffle_epi32(bytes, 0); }
  static std::uint64_t within(const std::uint32_t* boxes, Vector bounds) {
    const Vector low = _mm_packs_epi32(four(boxes, bounds), four(boxes + 4, bounds));
    const Vector high = _mm_packs_epi32(four(boxes + 8, bounds), four(boxes + 12, bounds));
    return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
  }

 private:
  static Vector four(const std::uint32_t* from, Vector bounds) {
    const Vector boxes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
    return _mm_cmpeq_epi32(_mm_min_epu8(boxes, bounds), boxes);
  }
};

}  // namespace

constinit const Kernels kSse41Kernels =
    make_kernels<Sse41Lanes>(VectorIsa::sse41, "sse4.1", eight_rows_in_turn, sweep<Sse41FourBytes>);

}  // namespace cellsweep::stream
