#include <immintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/lanes_avx2.h"
#include "engines/stream/kernels/sets.h"
#include "engines/stream/kernels/sweep.h"

namespace cellsweep::stream {
namespace {

/// Thirty-two boxes of four bytes at a time.
struct Avx2FourBytes {
  static constexpr unsigned kBoxes = 32;
  using Vector = __m256i;

  static Vector broadcast(__m128i bytes) { return _mm256_broadcastd_epi32(bytes); }
  static std::uint64_t within(const std::uint32_t* boxes, Vector bounds) {
    const Vector low = _mm256_packs_epi32(eight(boxes, bounds), eight(boxes + 8, bounds));
    const Vector high = _mm256_packs_epi32(eight(boxes + 16, bounds), eight(boxes + 24, bounds));
    // The lower four of each eight, then the upper ones: vectors are packed by halves.
    const Vector fours = _mm256_packs_epi16(low, high);
    const Vector all = _mm256_permutevar8x32_epi32(fours, _mm256_setr_epi32(0, 4, 1, 5, 2, 6, 3, 7));
    return static_cast<std::uint32_t>(_mm256_movemask_epi8(all));
  }

 private:
  static Vector eight(const std::uint32_t* from, Vector bounds) {
    const Vector boxes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    return _mm256_cmpeq_epi32(_mm256_min_epu8(boxes, bounds), boxes);
  }
};

}  // namespace

constinit const Kernels kAvx2Kernels =
    make_kernels<Avx2Lanes>(VectorIsa::avx2, "avx2", eight_rows_at_once, sweep<Avx2FourBytes>);

}  // namespace cellsweep::stream
