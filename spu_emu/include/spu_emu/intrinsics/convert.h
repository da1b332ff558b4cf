// Between types: spu_extend, spu_roundtf, and spu_convtf/spu_convts/spu_convtu with a power-of-two scale.
//
// Scales are 0 to 127 fraction bits. Conversions between integers and floats follow the SPU's arithmetic:
// they truncate, saturate, take exponent 255 for a large number, and rely on the SPU's MXCSR as float.h does.
// spu_extend and spu_roundtf between float and double are IEEE (infinity and NaN exist), and read and write
// the even elements of the float vector, as on the SPU.
#ifndef SPU_EMU_INTRINSICS_CONVERT_H
#define SPU_EMU_INTRINSICS_CONVERT_H

#include "spu_emu/intrinsics/double.h"
#include "spu_emu/intrinsics/float_precise.h"

// Sign-extends the odd elements: the right half of each wider lane.
SPU_EMU_INLINE vec_short8 spu_extend(vec_char16 v) {
  const __m128i left = spu_emu::detail::is_big_endian ? _mm_slli_epi16((__m128i)v, 8) : (__m128i)v;
  return (vec_short8)_mm_srai_epi16(left, 8);
}

SPU_EMU_INLINE vec_int4 spu_extend(vec_short8 v) {
  const __m128i left = spu_emu::detail::is_big_endian ? _mm_slli_epi32((__m128i)v, 16) : (__m128i)v;
  return (vec_int4)_mm_srai_epi32(left, 16);
}

SPU_EMU_INLINE vec_llong2 spu_extend(vec_int4 v) {
  const __m128i odd = _mm_shuffle_epi32((__m128i)v, _MM_SHUFFLE(3, 3, 3, 1));
  return (vec_llong2)_mm_cvtepi32_epi64(odd);
}

SPU_EMU_INLINE vec_double2 spu_extend(vec_float4 v) {
  const __m128i b = (__m128i)v;
  const __m128i exponent = _mm_and_si128(b, _mm_set1_epi32(0x7f800000));
  const __m128i is_zero = _mm_cmpeq_epi32(exponent, _mm_setzero_si128());
  const __m128i flushed = _mm_andnot_si128(_mm_and_si128(is_zero, _mm_set1_epi32(0x7fffffff)), b);
  const __m128 even = _mm_castsi128_ps(_mm_shuffle_epi32(flushed, _MM_SHUFFLE(3, 1, 2, 0)));
  return (vec_double2)spu_emu::detail::default_nan(_mm_cvtps_pd(even));
}

namespace spu_emu::detail {

SPU_EMU_INLINE __m128 default_nan(__m128 v) {
  const __m128 nan = _mm_castsi128_ps(_mm_set1_epi32(0x7fc00000));
  return _mm_blendv_ps(v, nan, _mm_cmpunord_ps(v, v));
}

}  // namespace spu_emu::detail

// Rounds by the FPSCR; the odd elements become zero.
SPU_EMU_INLINE vec_float4 spu_roundtf(vec_double2 v) {
  namespace d = spu_emu::detail;
  const auto operation = [](__m128d x, __m128d, __m128d) { return _mm_castps_pd(_mm_cvtpd_ps(x)); };
  const __m128d flushed = d::flush_denormal((__m128d)v);
  const d::DoubleRounding mode = d::double_rounding();
  __m128 pair = _mm_castpd_ps(d::rounded(mode.slot[0], operation, flushed, flushed, flushed));
  if (__builtin_expect(mode.slot[0] != mode.slot[1], 0)) {
    const __m128d other = d::rounded(mode.slot[1], operation, flushed, flushed, flushed);
    pair = _mm_blend_ps(pair, _mm_castpd_ps(other), 2);
  }
  return (vec_float4)_mm_unpacklo_ps(d::default_nan(pair), _mm_setzero_ps());
}

namespace spu_emu::detail {

// 2^exponent for exponents -126 to 127, in all lanes.
SPU_EMU_INLINE __m128 power_of_two(int exponent) {
  return _mm_castsi128_ps(_mm_set1_epi32((exponent + 127) << 23));
}

// v / 2^scale. 2^-127 has no float of its own, so the last factor of a half is a step of its own.
SPU_EMU_INLINE __m128 scale_down(__m128 v, unsigned int scale) {
  const __m128 scaled = _mm_mul_ps(v, power_of_two(-static_cast<int>(scale < 126 ? scale : 126)));
  return scale > 126 ? _mm_mul_ps(scaled, _mm_set1_ps(0.5f)) : scaled;
}

// What underflowed to -0 is +0 on an SPU.
SPU_EMU_INLINE vec_float4 positive_zero(__m128 v) {
  const __m128i is_zero = _mm_cmpeq_epi32(_mm_slli_epi32(_mm_castps_si128(v), 1), _mm_setzero_si128());
  return (vec_float4)_mm_andnot_si128(is_zero, _mm_castps_si128(v));
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_float4 spu_convtf(vec_int4 v, unsigned int scale) {
  namespace d = spu_emu::detail;
  return d::positive_zero(d::scale_down(_mm_cvtepi32_ps((__m128i)v), scale & 127));
}

// Both halves of the word convert exactly; their sum rounds once.
SPU_EMU_INLINE vec_float4 spu_convtf(vec_uint4 v, unsigned int scale) {
  const __m128 high = _mm_cvtepi32_ps((__m128i)(v >> 16));
  const __m128 low = _mm_cvtepi32_ps(_mm_and_si128((__m128i)v, _mm_set1_epi32(0xffff)));
  const __m128 whole = _mm_add_ps(_mm_mul_ps(high, _mm_set1_ps(65536.0f)), low);
  return (vec_float4)spu_emu::detail::scale_down(whole, scale & 127);
}

namespace spu_emu::detail {

// cvttps2dq as the machine does it: GCC would fold a constant NaN to 0 instead of 0x80000000.
SPU_EMU_INLINE __m128i truncate_to_words(__m128 v) {
#ifdef __SSE4_1__
  asm("" : "+x"(v));
#endif
  return _mm_cvttps_epi32(v);
}

}  // namespace spu_emu::detail

// x86 gives 0x80000000 for all that does not fit; for positive numbers the SPU gives 0x7fffffff.
SPU_EMU_INLINE vec_int4 spu_convts(vec_float4 v, int scale) {
  const __m128 scaled = _mm_mul_ps((__m128)v, spu_emu::detail::power_of_two(scale & 127));
  const __m128i whole = spu_emu::detail::truncate_to_words(scaled);
  const __m128i too_large = _mm_cmpeq_epi32(whole, _mm_set1_epi32(INT32_MIN));
  const __m128i negative = _mm_srai_epi32((__m128i)v, 31);
  return (vec_int4)_mm_xor_si128(whole, _mm_andnot_si128(negative, too_large));
}

// Negative numbers give 0. From 2^31 on the conversion works on the distance to it.
SPU_EMU_INLINE vec_uint4 spu_convtu(vec_float4 v, int scale) {
  const __m128 scaled = _mm_mul_ps((__m128)v, spu_emu::detail::power_of_two(scale & 127));
  const __m128i b = _mm_castps_si128(scaled);
  const __m128i in_upper_half = _mm_cmpgt_epi32(b, _mm_set1_epi32(0x4effffff));
  const __m128i too_large = _mm_cmpgt_epi32(b, _mm_set1_epi32(0x4f7fffff));
  const __m128 offset = _mm_and_ps(_mm_castsi128_ps(in_upper_half), _mm_set1_ps(2147483648.0f));
  const __m128i whole = spu_emu::detail::truncate_to_words(_mm_sub_ps(scaled, offset));
  const __m128i with_offset = _mm_xor_si128(whole, _mm_slli_epi32(in_upper_half, 31));
  const __m128i negative = _mm_srai_epi32((__m128i)v, 31);
  return (vec_uint4)_mm_andnot_si128(negative, _mm_or_si128(with_offset, too_large));
}

#endif
