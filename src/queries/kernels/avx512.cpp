#include <immintrin.h>

#include "queries/kernels/lanes_avx2.h"
#include "queries/kernels/sets.h"

namespace cellsweep::queries {
namespace {

/// Sixteen boxes at a time. Of the second eight none is read when none is there.
struct Avx512QueryLanes : LanesInOrder<16> {
  using Vector = __m512;
  using Mask = std::uint32_t;

  static void gather(const std::byte* boxes, std::size_t step, std::uint32_t there, Vector (&faces)[6]) {
    __m256 low[6];
    __m256 high[6];
    stream::gather_eight(reinterpret_cast<const Aabb*>(boxes), step, low);
    stream::gather_eight(reinterpret_cast<const Aabb*>(boxes + (there > 8 ? 8 * step : 0)), step, high);
    for (unsigned face = 0; face < 6; ++face) {
      faces[face] = __builtin_shufflevector(low[face], high[face], 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
                                            13, 14, 15);
    }
  }
  static Vector not_negative(Vector a) { return _mm512_maskz_max_ps(0xffff, a, _mm512_setzero_ps()); }
  static Mask less_equal(Vector a, Vector b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
  static std::uint32_t bits(Mask mask) { return mask; }
};

/// The same of boxes of 32 bytes, two in a vector: lanes are in the order in which the fewest shuffles leave
/// them.
struct Avx512TaggedLanes : Avx512QueryLanes {
  static void gather(const std::byte* boxes, std::size_t /*step*/, std::uint32_t there, Vector (&faces)[6]) {
    const std::size_t second = there > 8 ? 256 : 0;
    Vector low_xy[2], low_zx[2], low_yz[2], high_x[2];
    for (std::size_t half = 0; half < 2; ++half) {
      const auto pair = [&](std::size_t i) { return _mm512_loadu_ps(boxes + second * half + 64 * i); };
      const Vector a = floats_low(pair(0), pair(1)), b = floats_low(pair(2), pair(3));
      const Vector c = floats_high(pair(0), pair(1)), d = floats_high(pair(2), pair(3));
      low_xy[half] = doubles_low(a, b);   // x of the minimum, y of the maximum
      low_yz[half] = doubles_high(a, b);  // y of the minimum, z of the maximum
      low_zx[half] = doubles_low(c, d);   // z of the minimum
      high_x[half] = doubles_high(c, d);  // x of the maximum
    }
    faces[0] = even_fours(low_xy[0], low_xy[1]);
    faces[1] = even_fours(low_yz[0], low_yz[1]);
    faces[2] = even_fours(low_zx[0], low_zx[1]);
    faces[3] = even_fours(high_x[0], high_x[1]);
    faces[4] = odd_fours(low_xy[0], low_xy[1]);
    faces[5] = odd_fours(low_yz[0], low_yz[1]);
  }

  static std::uint32_t lanes_below(std::uint32_t count) {
    return _mm512_cmplt_epi32_mask(places(), _mm512_set1_epi32(static_cast<int>(count)));
  }
  static std::uint32_t place_of(unsigned lane) { return (lane & 8) | (lane & 3) << 1 | (lane >> 2 & 1); }
  static std::uint32_t put_places(std::uint32_t lanes, std::uint32_t first, std::uint32_t* to) {
    const __m512i here = _mm512_add_epi32(places(), _mm512_set1_epi32(static_cast<int>(first)));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(lanes), here));
    return static_cast<std::uint32_t>(__builtin_popcount(lanes));
  }

 private:
  static __m512i places() { return _mm512_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7, 8, 10, 12, 14, 9, 11, 13, 15); }

  // Of each four lanes the first two, or the last two, of both vectors in turn.
  static Vector floats_low(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
  }
  static Vector floats_high(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
  }
  // The same of pairs of lanes.
  static Vector doubles_low(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
  }
  static Vector doubles_high(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
  }
  // Each second four lanes.
  static Vector even_fours(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27);
  }
  static Vector odd_fours(Vector a, Vector b) {
    return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31);
  }
};

/// The largest number below one that is canonical.
float next_below(float number) {
  if (number == 0) return -__FLT_DENORM_MIN__;
  const auto bits = __builtin_bit_cast(std::uint32_t, number);
  return __builtin_bit_cast(float, number > 0 ? bits - 1 : bits + 1);
}

/// Eight boxes of a cell, two in a vector as they lie there: one comparison tells of all numbers of both,
/// which takes less than to put the boxes side by side. A box overlaps another one when its minima are no
/// more than that one's maxima, and its maxima are more than the numbers below that one's minima.
class Avx512InCell {
 public:
  static constexpr std::uint32_t kBoxes = 8;

  explicit Avx512InCell(const Aabb& box) : bounds_(bounds_of(reinterpret_cast<const float*>(&box))) {}

  std::uint64_t test(const stream::TaggedBox* boxes) const {
    const __mmask64 four = _mm512_kunpackd(two(boxes + 6, boxes + 4), two(boxes + 2, boxes));
    return low_bits(no_bits_wrong(std::uint64_t{four}));
  }

 private:
  static __m512 bounds_of(const float* faces) {
    return twice(_mm256_setr_ps(faces[3], faces[4], faces[5], next_below(faces[0]), next_below(faces[1]),
                                next_below(faces[2]), 0, 0));
  }
  static __m512 twice(__m256 numbers) {
    return __builtin_shufflevector(numbers, numbers, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7);
  }

  // A bit for each number that is no more than its bound: eight for each of four boxes.
  __mmask32 two(const stream::TaggedBox* high, const stream::TaggedBox* low) const {
    return _mm512_kunpackw(no_more(high), no_more(low));
  }
  __mmask16 no_more(const stream::TaggedBox* two) const {
    return _mm512_cmp_ps_mask(_mm512_loadu_ps(two), bounds_, _CMP_LE_OQ);
  }

  // The top bit but one of each byte whose lower six are those of a box that overlaps.
  static std::uint64_t no_bits_wrong(std::uint64_t bytes) {
    constexpr std::uint64_t kEach = 0x0101010101010101;
    const std::uint64_t wrong = (bytes & kEach * 0x3f) ^ kEach * 0x07;
    return (kEach * 0x40 - wrong) & kEach * 0x40;
  }
  // Of eight bytes, as eight bits.
  static std::uint64_t low_bits(std::uint64_t bytes) { return (bytes >> 6) * 0x0102040810204080 >> 56; }

  __m512 bounds_;
};

}  // namespace

constinit const QueryKernels kAvx512Queries =
    make_query_kernels<Avx512TaggedLanes, Avx512QueryLanes, Avx2QueryLanes, Avx512InCell>(VectorIsa::avx512,
                                                                                          kAvx2Trees);

}  // namespace cellsweep::queries
