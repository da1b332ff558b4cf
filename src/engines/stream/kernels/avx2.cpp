#include <immintrin.h>

#include "engines/stream/kernels/body.h"
#include "engines/stream/kernels/eight_avx2.h"
#include "engines/stream/kernels/sets.h"

namespace cellsweep::stream {
namespace {

/// Eight boxes at a time.
struct Avx2Lanes {
  static constexpr unsigned kCount = 8;
  static constexpr auto kEightBlocks = eight_blocks_at_once;
  using Vector = __m256;
  using Mask = __m256;

  static void gather(const TaggedBox* boxes, Vector (&faces)[6]) {
    gather_eight(&boxes->box, sizeof(TaggedBox), faces);
  }
  static Vector broadcast(const float* from) { return _mm256_broadcast_ss(from); }
  static Mask less_equal(Vector a, Vector b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
  static Mask both(Mask a, Mask b) { return _mm256_and_ps(a, b); }
  static std::uint32_t bits(Mask mask) { return static_cast<std::uint32_t>(_mm256_movemask_ps(mask)); }
};

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

constinit const Kernels kAvx2Kernels = make_kernels<Avx2Lanes, Avx2Bytes>(VectorIsa::avx2, "avx2");

}  // namespace cellsweep::stream
