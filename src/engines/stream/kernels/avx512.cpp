#include <immintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_avx512.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Sixty-four bytes at a time.
struct Avx512Bytes {
  static constexpr unsigned kCount = 64;
  using Vector = __m512i;
  using Mask = __mmask64;

  static Vector broadcast(std::uint8_t byte) { return _mm512_set1_epi8(static_cast<char>(byte)); }
  static Vector load(const std::uint8_t* from) { return _mm512_loadu_si512(from); }
  static Mask less_equal(Vector a, Vector b) { return _mm512_cmple_epu8_mask(a, b); }
  static Mask both(Mask a, Mask b) { return a & b; }
  static std::uint64_t bits(Mask mask) { return mask; }
};

}  // namespace

constinit const Kernels kAvx512Kernels =
    make_kernels<Avx512Lanes>(VectorIsa::avx512, "avx512", eight_rows_at_once, sweep<Avx512Bytes>);

}  // namespace cellsweep::stream
