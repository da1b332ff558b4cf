#include <immintrin.h>

#include "engines/stream/kernel_body.h"
#include "engines/stream/kernel_sets.h"

namespace cellsweep::stream {
namespace {

/// Four boxes at a time.
struct Sse41Lanes {
  static constexpr unsigned kCount = 4;
  using Vector = __m128;
  using Mask = __m128;

  static Vector load(const float* from) { return _mm_loadu_ps(from); }
  static Vector broadcast(const float* from) { return _mm_load1_ps(from); }
  static Mask less_equal(Vector a, Vector b) { return _mm_cmple_ps(a, b); }
  static Mask both(Mask a, Mask b) { return _mm_and_ps(a, b); }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm_movemask_ps(mask)); }
};

}  // namespace

const Kernels kSse41Kernels = make_kernels<Sse41Lanes>(VectorIsa::sse41, "sse4.1");

}  // namespace cellsweep::stream
