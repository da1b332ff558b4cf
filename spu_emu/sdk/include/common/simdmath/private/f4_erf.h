/* The error function and what it lacks to 1. */
#ifndef SPU_EMU_SIMDMATH_F4_ERF_H
#define SPU_EMU_SIMDMATH_F4_ERF_H

#include "simdmath/private/f4_divide.h"
#include "simdmath/private/f4_exp.h"

/* erfc(a) for a from 0 on: e^(-a^2) (1 + p) / (1 + 2 a), the square as two numbers. */
SM_INLINE vec_float4 sm_ferfc_positive(vec_float4 magnitude) {
  const vec_float4 a = sm_flimit(magnitude, SM_F4(10.5f));
  const vec_float4 one = SM_F4(1.0f);
  const vec_float4 square = sm_fmul(a, a);
  const vec_float4 square_low = sm_fneg(sm_fnmsub(a, a, square));
  const vec_float4 four = SM_F4(4.0f);
  const vec_float4 p = sm_poly_erfc_f4(sm_fdivide(sm_fsub(a, four), sm_fadd(a, four)));
  vec_int4 power;
  vec_float4 minus_one = sm_fexp_parts(sm_fneg(square), &power);
  minus_one = sm_fnmsub(square_low, sm_fadd(minus_one, one), minus_one);
  minus_one = sm_fmadd(p, sm_fadd(minus_one, one), minus_one);
  return sm_fscale(sm_fdivide(sm_fadd(minus_one, one), sm_fmadd(SM_F4(2.0f), a, one)), power);
}

/* erf(x) for |x| up to 1. The SPU's zero has no sign. */
SM_INLINE vec_float4 sm_ferf_near(vec_float4 x) {
  const vec_float4 result = sm_fmadd(sm_poly_erf_f4(sm_fmul(x, x)), x, x);
#ifdef __SPU__
  return (vec_float4)((vec_uint4)result & ~sm_fis_zero(x));
#else
  return result;
#endif
}

static inline vec_float4 _erff4(vec_float4 x) {
  const vec_uint4 near = sm_igt((vec_int4)SM_F_ONE, sm_fbits(x));
  const vec_float4 of_near = sm_ferf_near((vec_float4)((vec_uint4)x & near));
  const vec_float4 far = sm_fsigned(sm_fsub(SM_F4(1.0f), sm_ferfc_positive(sm_fabs(x))), sm_fsign(x));
  return sm_fkeep_nan(sm_fsel(far, of_near, near), x);
}

static inline vec_float4 _erfcf4(vec_float4 x) {
  const vec_uint4 near = sm_igt((vec_int4)SM_F4(0.5f), sm_fbits(x));
  const vec_uint4 negative = (vec_uint4)((vec_int4)x >> 31);
  const vec_float4 of_near = sm_fsub(SM_F4(1.0f), sm_ferf_near((vec_float4)((vec_uint4)x & near)));
  const vec_float4 of_positive = sm_ferfc_positive(sm_fabs(x));
  const vec_float4 far = sm_fsel(of_positive, sm_fsub(SM_F4(2.0f), of_positive), negative);
  return sm_fkeep_nan(sm_fsel(far, of_near, near), x);
}

#endif
