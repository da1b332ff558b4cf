// Counting and collecting bits: spu_cntb, spu_cntlz, spu_gather, and the masks made from bits, spu_maskb/h/w.
#ifndef SPU_EMU_INTRINSICS_BITS_H
#define SPU_EMU_INTRINSICS_BITS_H

#include "spu_emu/intrinsics/traits.h"

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, vec_uchar16, 1> spu_cntb(V v) {
  const __m128i ones_of = _mm_setr_epi8(0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4);
  const __m128i nibble = _mm_set1_epi8(0x0f);
  const __m128i low = _mm_and_si128((__m128i)v, nibble);
  const __m128i high = _mm_and_si128(_mm_srli_epi16((__m128i)v, 4), nibble);
  return (vec_uchar16)_mm_add_epi8(_mm_shuffle_epi8(ones_of, low), _mm_shuffle_epi8(ones_of, high));
}

// Leading zeros of each word, 32 for zero; a float counts by its bits.
template <typename V>
SPU_EMU_INLINE std::enable_if_t<spu_emu::detail::lane_bytes<V> == 4, vec_uint4> spu_cntlz(V v) {
#if defined(__AVX512CD__) && defined(__AVX512VL__)
  return (vec_uint4)_mm_lzcnt_epi32((__m128i)v);
#else
  vec_uint4 x = (vec_uint4)v;
  x |= x >> 1;
  x |= x >> 2;
  x |= x >> 4;
  x |= x >> 8;
  x |= x >> 16;
  const __m128i counts = (__m128i)spu_cntb((vec_uchar16)~x);
  const __m128i pairs = _mm_maddubs_epi16(counts, _mm_set1_epi8(1));
  return (vec_uint4)_mm_madd_epi16(pairs, _mm_set1_epi16(1));
#endif
}

namespace spu_emu::detail {

// The lowest bit of each lane, element 0's as the most significant.
template <typename V>
SPU_EMU_INLINE unsigned int gathered_bits(V v) {
  const __m128i b = (__m128i)v;
  if constexpr (lane_bytes<V> == 4) {
    const __m128i reversed = _mm_shuffle_epi32(_mm_slli_epi32(b, 31), _MM_SHUFFLE(0, 1, 2, 3));
    return static_cast<unsigned int>(_mm_movemask_ps(_mm_castsi128_ps(reversed)));
  } else if constexpr (lane_bytes<V> == 2) {
    constexpr int low = is_big_endian ? 1 : 0;  // the byte of a lane that has its lowest bit
    const __m128i order = _mm_setr_epi8(14 + low, 12 + low, 10 + low, 8 + low, 6 + low, 4 + low, 2 + low, low,
                                        -1, -1, -1, -1, -1, -1, -1, -1);
    return static_cast<unsigned int>(_mm_movemask_epi8(_mm_shuffle_epi8(_mm_slli_epi16(b, 7), order)));
  } else {
    const __m128i order = _mm_setr_epi8(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    return static_cast<unsigned int>(_mm_movemask_epi8(_mm_shuffle_epi8(_mm_slli_epi16(b, 7), order)));
  }
}

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE std::enable_if_t<(spu_emu::detail::lane_bytes<V> <= 4), vec_uint4> spu_gather(V v) {
  return vec_uint4{spu_emu::detail::gathered_bits(v), 0, 0, 0};
}

// Sixteen byte masks from the low 16 bits, the most significant of them for element 0. Any integer type is
// taken.
SPU_EMU_INLINE vec_uchar16 spu_maskb(unsigned int mask) {
  constexpr int high = spu_emu::detail::is_big_endian ? 2 : 1;  // where in a word its two low bytes are
  constexpr int low = spu_emu::detail::is_big_endian ? 3 : 0;
  const __m128i order =
      _mm_setr_epi8(high, high, high, high, high, high, high, high, low, low, low, low, low, low, low, low);
  const __m128i spread = _mm_shuffle_epi8(_mm_cvtsi32_si128(static_cast<int>(mask)), order);
  const __m128i bit = _mm_setr_epi8(-128, 64, 32, 16, 8, 4, 2, 1, -128, 64, 32, 16, 8, 4, 2, 1);
  return (vec_uchar16)_mm_cmpeq_epi8(_mm_and_si128(spread, bit), bit);
}

SPU_EMU_INLINE vec_ushort8 spu_maskh(unsigned int mask) {
  const __m128i bit = _mm_setr_epi16(0x80, 0x40, 0x20, 0x10, 8, 4, 2, 1);
  return (vec_ushort8)_mm_cmpeq_epi16(_mm_and_si128(_mm_set1_epi16(static_cast<short>(mask)), bit), bit);
}

SPU_EMU_INLINE vec_uint4 spu_maskw(unsigned int mask) {
  const __m128i bit = _mm_setr_epi32(8, 4, 2, 1);
  return (vec_uint4)_mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(static_cast<int>(mask)), bit), bit);
}

#endif
