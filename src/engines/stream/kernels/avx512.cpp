#include <immintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_avx512.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Sixty-four boxes of four bytes at a time.
struct Avx512FourBytes {
  static constexpr unsigned kBoxes = 64;
  using Vector = __m512i;

  // Not _mm512_broadcastd_epi32(), of which GCC 12 warns that it reads what was not set.
  static Vector broadcast(__m128i bytes) { return _mm512_maskz_broadcastd_epi32(0xffff, bytes); }
  static std::uint64_t within(const std::uint32_t* boxes, Vector bounds) {
    const __mmask32 low = _mm512_kunpackw(sixteen(boxes + 16, bounds), sixteen(boxes, bounds));
    const __mmask32 high = _mm512_kunpackw(sixteen(boxes + 48, bounds), sixteen(boxes + 32, bounds));
    return _mm512_kunpackd(high, low);
  }

 private:
  static __mmask16 sixteen(const std::uint32_t* boxes, Vector bounds) {
    const Vector above = _mm512_subs_epu8(_mm512_loadu_si512(boxes), bounds);
    return _mm512_testn_epi32_mask(above, above);
  }
};

}  // namespace

constinit const Kernels kAvx512Kernels =
    make_kernels<Avx512Lanes>(VectorIsa::avx512, "avx512", eight_rows_at_once, sweep<Avx512FourBytes>);

}  // namespace cellsweep::stream
