// Single precision bit for bit as an SPU does it, for every input: the arithmetic of SPU_EMU_PRECISE builds.
//
// Exponent 255 is an ordinary exponent, magnitudes below 2^-126 are zero, every zero result is +0, and
// overflow gives the largest magnitude, 0x7fffffff. All SPU floats and all their products are exact in double
// precision, and rounding a double toward zero and then dropping bits equals rounding the exact result toward
// zero once. Relies on the thread's rounding mode being toward zero (float_mode.h).
#ifndef SPU_EMU_INTRINSICS_FLOAT_PRECISE_H
#define SPU_EMU_INTRINSICS_FLOAT_PRECISE_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

struct WideFloat {
  __m128d low;   // elements 0 and 1
  __m128d high;  // elements 2 and 3
};

constexpr int least_normal_float = 0x00800000;
constexpr int exponent_shift_in_high_word = 896 << 20;  // 1023 - 127, as a double's high word holds it

// Words of doubles, of two at a time: high and low parts of four lanes in the places of this processor.
SPU_EMU_INLINE WideFloat join_words(__m128i high, __m128i low) {
  const __m128i first = is_big_endian ? high : low;
  const __m128i second = is_big_endian ? low : high;
  return {_mm_castsi128_pd(_mm_unpacklo_epi32(first, second)),
          _mm_castsi128_pd(_mm_unpackhi_epi32(first, second))};
}

SPU_EMU_INLINE __m128i even_words(WideFloat v) {
  return _mm_castps_si128(
      _mm_shuffle_ps(_mm_castpd_ps(v.low), _mm_castpd_ps(v.high), _MM_SHUFFLE(2, 0, 2, 0)));
}

SPU_EMU_INLINE __m128i odd_words(WideFloat v) {
  return _mm_castps_si128(
      _mm_shuffle_ps(_mm_castpd_ps(v.low), _mm_castpd_ps(v.high), _MM_SHUFFLE(3, 1, 3, 1)));
}

SPU_EMU_INLINE __m128i high_words(WideFloat v) {
  return is_big_endian ? even_words(v) : odd_words(v);
}

SPU_EMU_INLINE __m128i low_words(WideFloat v) {
  return is_big_endian ? odd_words(v) : even_words(v);
}

SPU_EMU_INLINE WideFloat widen(vec_float4 v) {
  const __m128i b = (__m128i)v;
  const __m128i magnitude = _mm_and_si128(b, _mm_set1_epi32(0x7fffffff));
  const __m128i nonzero = _mm_cmpgt_epi32(magnitude, _mm_set1_epi32(least_normal_float - 1));
  const __m128i exponent =
      _mm_add_epi32(_mm_srli_epi32(magnitude, 3), _mm_set1_epi32(exponent_shift_in_high_word));
  const __m128i sign = _mm_xor_si128(b, magnitude);
  const __m128i high = _mm_and_si128(_mm_or_si128(exponent, sign), nonzero);
  const __m128i low = _mm_and_si128(_mm_slli_epi32(b, 29), nonzero);
  return join_words(high, low);
}

SPU_EMU_INLINE vec_float4 narrow(WideFloat v) {
  const __m128i low = low_words(v);
  const __m128i high = high_words(v);
  const __m128i magnitude = _mm_and_si128(high, _mm_set1_epi32(0x7fffffff));
  const __m128i sign = _mm_xor_si128(high, magnitude);
  const __m128i least = _mm_set1_epi32(exponent_shift_in_high_word + (1 << 20));
  const __m128i largest = _mm_set1_epi32(exponent_shift_in_high_word + (256 << 20) - 1);
  const __m128i is_zero = _mm_cmpgt_epi32(least, magnitude);
  const __m128i overflow = _mm_cmpgt_epi32(magnitude, largest);
  const __m128i rebased = _mm_sub_epi32(magnitude, _mm_set1_epi32(exponent_shift_in_high_word));
  __m128i result = _mm_or_si128(_mm_slli_epi32(rebased, 3), _mm_srli_epi32(low, 29));
  result = _mm_blendv_epi8(result, _mm_set1_epi32(0x7fffffff), overflow);
  return (vec_float4)_mm_andnot_si128(is_zero, _mm_or_si128(result, sign));
}

SPU_EMU_INLINE vec_float4 precise_add(vec_float4 a, vec_float4 b) {
  const WideFloat x = widen(a);
  const WideFloat y = widen(b);
  return narrow({_mm_add_pd(x.low, y.low), _mm_add_pd(x.high, y.high)});
}

SPU_EMU_INLINE vec_float4 precise_sub(vec_float4 a, vec_float4 b) {
  const WideFloat x = widen(a);
  const WideFloat y = widen(b);
  return narrow({_mm_sub_pd(x.low, y.low), _mm_sub_pd(x.high, y.high)});
}

SPU_EMU_INLINE vec_float4 precise_mul(vec_float4 a, vec_float4 b) {
  const WideFloat x = widen(a);
  const WideFloat y = widen(b);
  return narrow({_mm_mul_pd(x.low, y.low), _mm_mul_pd(x.high, y.high)});
}

SPU_EMU_INLINE vec_float4 precise_madd(vec_float4 a, vec_float4 b, vec_float4 c) {
  const WideFloat x = widen(a);
  const WideFloat y = widen(b);
  const WideFloat z = widen(c);
  return narrow(
      {_mm_add_pd(_mm_mul_pd(x.low, y.low), z.low), _mm_add_pd(_mm_mul_pd(x.high, y.high), z.high)});
}

}  // namespace spu_emu::detail

#endif
