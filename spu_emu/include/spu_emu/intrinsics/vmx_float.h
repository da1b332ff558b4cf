// vmx2spu.h: float functions: rounding to integers, estimates of powers and logarithms, and forwards to spu_
// ones.
#ifndef SPU_EMU_INTRINSICS_VMX_FLOAT_H
#define SPU_EMU_INTRINSICS_VMX_FLOAT_H

#include "spu_emu/intrinsics/convert.h"
#include "spu_emu/intrinsics/estimate.h"
#include "spu_emu/intrinsics/float.h"
#include "spu_emu/intrinsics/float_compare.h"
#include "spu_emu/intrinsics/vmx_types.h"

namespace spu_emu::detail {

// From 2^23 on every float, exponent 255 included, is an integer already. Zero results are +0, as elsewhere
// on the SPU, and denormals count as zero.
template <int Mode>
SPU_EMU_INLINE vec_float4 round_to_integer(vec_float4 v) {
  const __m128i size = (__m128i)magnitude(v);
  const __m128i is_integer = _mm_cmpgt_epi32(size, _mm_set1_epi32(0x4affffff));
  const __m128i nonzero = _mm_cmpgt_epi32(size, _mm_set1_epi32(least_normal_float - 1));
  const __m128 flushed = _mm_castsi128_ps(_mm_and_si128((__m128i)v, nonzero));
  const __m128 rounded_value = _mm_round_ps(flushed, Mode | _MM_FROUND_NO_EXC);
  return positive_zero(_mm_blendv_ps(rounded_value, (__m128)v, _mm_castsi128_ps(is_integer)));
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_float4 vec_ceil(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_POS_INF>(a);
}

SPU_EMU_INLINE vec_float4 vec_floor(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_NEG_INF>(a);
}

// To the nearest integer, halves to the even one.
SPU_EMU_INLINE vec_float4 vec_round(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_NEAREST_INT>(a);
}

SPU_EMU_INLINE vec_float4 vec_trunc(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_ZERO>(a);
}

// 2^a within 0.3 %, exact for integers. From 129 on the largest float, below -126 zero.
SPU_EMU_INLINE vec_float4 vec_expte(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_int4 fixed = spu_convts(a, 23);
  const vec_int4 exponent = (fixed >> 23) + d::splat<vec_int4>(127);
  const vec_float4 f = spu_convtf(fixed & d::splat<vec_int4>(0x7fffff), 23);
  const __m128 slope = _mm_add_ps(_mm_mul_ps((__m128)f, _mm_set1_ps(0.3398f)), _mm_set1_ps(0.6602f));
  const vec_int4 fraction = spu_convts((vec_float4)_mm_mul_ps((__m128)f, slope), 23);
  const vec_uint4 underflow = (vec_uint4)(exponent < d::splat<vec_int4>(1));
  const vec_uint4 overflow = (vec_uint4)(exponent > d::splat<vec_int4>(255));
  const vec_uint4 result = ((vec_uint4)exponent << 23) | (vec_uint4)fraction;
  return (vec_float4)((((result & ~overflow) | overflow) & d::splat<vec_uint4>(0x7fffffff)) & ~underflow);
}

// The binary logarithm of |a| within 0.01, exact for powers of two; the largest negative float for zero.
SPU_EMU_INLINE vec_float4 vec_loge(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_uint4 b = (vec_uint4)a;
  const vec_uint4 exponent = (b >> 23) & d::splat<vec_uint4>(255);
  const vec_float4 whole = spu_convtf((vec_int4)exponent - d::splat<vec_int4>(127), 0);
  const vec_float4 f = spu_convtf((vec_int4)(b & d::splat<vec_uint4>(0x7fffff)), 23);
  const __m128 slope = _mm_sub_ps(_mm_set1_ps(1.3465f), _mm_mul_ps((__m128)f, _mm_set1_ps(0.3465f)));
  const __m128 sum = _mm_add_ps((__m128)whole, _mm_mul_ps((__m128)f, slope));
  return (vec_float4)((vec_uint4)sum | (vec_uint4)(exponent == d::splat<vec_uint4>(0)));
}

SPU_EMU_INLINE vec_float4 vec_madd(vec_float4 a, vec_float4 b, vec_float4 c) {
  return spu_madd(a, b, c);
}

SPU_EMU_INLINE vec_float4 vec_nmsub(vec_float4 a, vec_float4 b, vec_float4 c) {
  return spu_nmsub(a, b, c);
}

SPU_EMU_INLINE vec_float4 vec_re(vec_float4 a) {
  return spu_re(a);
}

SPU_EMU_INLINE vec_float4 vec_rsqrte(vec_float4 a) {
  return spu_rsqrte(a);
}

template <typename V>
SPU_EMU_INLINE vec_float4 vec_ctf(V a, unsigned int scale) {
  return spu_convtf(a, scale);
}

SPU_EMU_INLINE vec_int4 vec_cts(vec_float4 a, int scale) {
  return spu_convts(a, scale);
}

SPU_EMU_INLINE vec_uint4 vec_ctu(vec_float4 a, int scale) {
  return spu_convtu(a, scale);
}

#endif
