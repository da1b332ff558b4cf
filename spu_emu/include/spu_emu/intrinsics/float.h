// Single-precision arithmetic: spu_add, spu_sub, spu_mul and the fused spu_madd, spu_msub, spu_nmsub.
//
// Rounds toward zero under the SPU's MXCSR (float_mode.h), which the thread must have set. In default builds
// the result is the SPU's bit for bit while no operand or result has exponent 255, but for the sign of a zero
// result; SPU_EMU_PRECISE builds have neither exception. Multiply-adds round once, with or without FMA
// instructions.
#ifndef SPU_EMU_INTRINSICS_FLOAT_H
#define SPU_EMU_INTRINSICS_FLOAT_H

#include "spu_emu/intrinsics/float_precise.h"

namespace spu_emu::detail {

SPU_EMU_INLINE vec_float4 negate(vec_float4 v) {
  return (vec_float4)_mm_xor_si128((__m128i)v, _mm_set1_epi32(INT32_MIN));
}

// a * b + c, rounded once. Without FMA through doubles, where the product is exact and, rounding toward zero,
// two roundings of the sum equal one.
SPU_EMU_INLINE vec_float4 sse_madd(vec_float4 a, vec_float4 b, vec_float4 c) {
#ifdef __FMA__
  return (vec_float4)_mm_fmadd_ps((__m128)a, (__m128)b, (__m128)c);
#else
  const __m128 x = (__m128)a;
  const __m128 y = (__m128)b;
  const __m128 z = (__m128)c;
  const __m128d low = _mm_add_pd(_mm_mul_pd(_mm_cvtps_pd(x), _mm_cvtps_pd(y)), _mm_cvtps_pd(z));
  const __m128d high =
      _mm_add_pd(_mm_mul_pd(_mm_cvtps_pd(_mm_movehl_ps(x, x)), _mm_cvtps_pd(_mm_movehl_ps(y, y))),
                 _mm_cvtps_pd(_mm_movehl_ps(z, z)));
  return (vec_float4)_mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high));
#endif
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_float4 spu_add(vec_float4 a, vec_float4 b) {
#ifdef SPU_EMU_PRECISE
  return spu_emu::detail::precise_add(a, b);
#else
  return (vec_float4)_mm_add_ps((__m128)a, (__m128)b);
#endif
}

SPU_EMU_INLINE vec_float4 spu_sub(vec_float4 a, vec_float4 b) {
#ifdef SPU_EMU_PRECISE
  return spu_emu::detail::precise_sub(a, b);
#else
  return (vec_float4)_mm_sub_ps((__m128)a, (__m128)b);
#endif
}

SPU_EMU_INLINE vec_float4 spu_mul(vec_float4 a, vec_float4 b) {
#ifdef SPU_EMU_PRECISE
  return spu_emu::detail::precise_mul(a, b);
#else
  return (vec_float4)_mm_mul_ps((__m128)a, (__m128)b);
#endif
}

// a * b + c.
SPU_EMU_INLINE vec_float4 spu_madd(vec_float4 a, vec_float4 b, vec_float4 c) {
#ifdef SPU_EMU_PRECISE
  return spu_emu::detail::precise_madd(a, b, c);
#else
  return spu_emu::detail::sse_madd(a, b, c);
#endif
}

// a * b - c.
SPU_EMU_INLINE vec_float4 spu_msub(vec_float4 a, vec_float4 b, vec_float4 c) {
  return spu_madd(a, b, spu_emu::detail::negate(c));
}

// c - a * b.
SPU_EMU_INLINE vec_float4 spu_nmsub(vec_float4 a, vec_float4 b, vec_float4 c) {
  return spu_madd(spu_emu::detail::negate(a), b, c);
}

// The scalar form of spu_madd.
SPU_EMU_INLINE float fmas(float a, float b, float c) {
  using spu_emu::detail::splat;
  return spu_madd(splat<vec_float4>(a), splat<vec_float4>(b), splat<vec_float4>(c))[0];
}

#endif
