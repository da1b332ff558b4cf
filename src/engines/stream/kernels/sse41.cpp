#include <smmintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_sse41.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Sixteen bytes at a time.
struct Sse41Bytes {
  static constexpr unsigned kCount = 16;
  using Vector = __m128i;

  static Vector broadcast(std::uint8_t byte) { return _mm_set1_epi8(static_cast<char>(byte)); }
  static Vector load(const std::uint8_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  }
  static Vector less_equal(Vector a, Vector b) { return _mm_cmpeq_epi8(_mm_min_epu8(a, b), a); }
  static Vector both(Vector a, Vector b) { return _mm_and_si128(a, b); }
  static std::uint64_t bits(Vector mask) { return static_cast<std::uint32_t>(_mm_movemask_epi8(mask)); }
};

}  // namespace

constinit const Kernels kSse41Kernels =
    make_kernels<Sse41Lanes>(VectorIsa::sse41, "sse4.1", eight_rows_in_turn, sweep<Sse41Bytes>);

}  // namespace cellsweep::stream
