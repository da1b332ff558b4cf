#include <immintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_avx2.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Thirty-two bytes at a time.
struct Avx2Bytes {
  static constexpr unsigned kCount = 32;
  using Vector = __m256i;

  static Vector broadcast(std::uint8_t byte) { return _mm256_set1_epi8(static_cast<char>(byte)); }
  static Vector load(const std::uint8_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  static Vector less_equal(Vector a, Vector b) { return _mm256_cmpeq_epi8(_mm256_min_epu8(a, b), a); }
  static Vector both(Vector a, Vector b) { return _mm256_and_si256(a, b); }
  static std::uint64_t bits(Vector mask) { return static_cast<std::uint32_t>(_mm256_movemask_epi8(mask)); }
};

}  // namespace

constinit const Kernels kAvx2Kernels =
    make_kernels<Avx2Lanes>(VectorIsa::avx2, "avx2", eight_rows_at_once, sweep<Avx2Bytes>);

}  // namespace cellsweep::stream
