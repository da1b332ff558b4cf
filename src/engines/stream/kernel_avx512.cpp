#include <immintrin.h>

#include "engines/stream/kernel_body.h"
#include "engines/stream/kernel_sets.h"

namespace cellsweep::stream {
namespace {

/// Sixteen boxes at a time.
struct Avx512Lanes {
  static constexpr unsigned kCount = 16;
  using Vector = __m512;
  using Mask = __mmask16;

  static Vector load(const float* from) { return _mm512_loadu_ps(from); }
  static Vector broadcast(const float* from) { return _mm512_set1_ps(*from); }
  static Mask less_equal(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
  static Mask both(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  static std::uint32_t bits(Mask mask) { return mask; }
};

}  // namespace

const Kernels kAvx512Kernels = make_kernels<Avx512Lanes>(VectorIsa::avx512, "avx512");

}  // namespace cellsweep::stream
