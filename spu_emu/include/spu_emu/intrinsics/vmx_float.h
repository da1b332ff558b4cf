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

// Magnitudes below these count as zero, as the sum by which an SPU rounds away from zero is truncated: the
// float before 1 added to less than 2^-24 stays below 1, and 0.5 added to the float after 0.5 is 1, as of a
// half.
constexpr int least_rounded_away = 0x33800000;
constexpr int least_rounded_to_nearest = 0x3f000002;

// From 2^23 on every float, exponent 255 included, is an integer already. Zero results are +0, as elsewhere
// on the SPU.
template <int Mode, int LeastMagnitude = least_rounded_away>
SPU_EMU_INLINE vec_float4 round_to_integer(vec_float4 v) {
  const __m128i size = (__m128i)magnitude(v);
  const __m128i is_integer = _mm_cmpgt_epi32(size, _mm_set1_epi32(0x4affffff));
  const __m128i counts = _mm_cmpgt_epi32(size, _mm_set1_epi32(LeastMagnitude - 1));
  const __m128 flushed = _mm_castsi128_ps(_mm_and_si128((__m128i)v, counts));
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

// To the nearest integer, halves, and the float after 0.5, to the even one.
SPU_EMU_INLINE vec_float4 vec_round(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_NEAREST_INT,
                                           spu_emu::detail::least_rounded_to_nearest>(a);
}

SPU_EMU_INLINE vec_float4 vec_trunc(vec_float4 a) {
  return spu_emu::detail::round_to_integer<_MM_FROUND_TO_ZERO>(a);
}

// 2^a within 0.4 %, exact for integers, for a from -126 to 128: a parabola below the next power of two.
// Elsewhere the exponent wraps into the sign. That power has exponent 255 for a above 127, which is why all
// builds compute precisely here. The coefficients are 0.17157287 and -0.67157287.
SPU_EMU_INLINE vec_float4 vec_expte(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_int4 negative = (vec_int4)a >> 31;
  const vec_float4 to_next = (vec_float4)(d::splat<vec_int4>(0x3f7fffff) & ~negative);
  const vec_int4 whole = spu_convts(spu_add(a, to_next), 0);
  const vec_float4 below = d::precise_sub(spu_convtf(whole, 0), a);
  const vec_float4 slope =
      d::precise_madd(d::splat<vec_float4>(0x1.5f6198p-3f), below, d::splat<vec_float4>(-0x1.57d866p-1f));
  const vec_float4 fraction = d::precise_madd(slope, below, d::splat<vec_float4>(1.0f));
  const vec_uint4 power = ((vec_uint4)whole + d::splat<vec_uint4>(127)) << 23;
  return d::precise_mul(fraction, (vec_float4)power);
}

// The binary logarithm of a positive float within 0.01: a parabola between powers of two, on the fraction
// moved to 1 to 2. Zero counts as 2^-127, and a negative fraction stays negative, which gives no logarithm.
// The coefficients are -0.33985, 2.01955 and 1.6797, truncated as the SPU's compiler truncates constants.
SPU_EMU_INLINE vec_float4 vec_loge(vec_float4 a) {
  namespace d = spu_emu::detail;
  const vec_uint4 b = (vec_uint4)a;
  const vec_int4 exponent = (vec_int4)((b >> 23) & d::splat<vec_uint4>(255)) - d::splat<vec_int4>(127);
  const vec_float4 fraction =
      (vec_float4)((b & d::splat<vec_uint4>(0x807fffffU)) | d::splat<vec_uint4>(0x3f800000));
  const vec_float4 slope =
      spu_madd(d::splat<vec_float4>(-0x1.5c01a2p-2f), fraction, d::splat<vec_float4>(0x1.02809cp+1f));
  const vec_float4 offset = spu_sub(spu_convtf(exponent, 0), d::splat<vec_float4>(0x1.ae00dp+0f));
  return spu_madd(slope, fraction, offset);
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
