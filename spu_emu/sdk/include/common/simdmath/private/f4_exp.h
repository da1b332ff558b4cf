/* Exponentials. */
#ifndef SPU_EMU_SIMDMATH_F4_EXP_H
#define SPU_EMU_SIMDMATH_F4_EXP_H

#include "simdmath/private/polynomials_f4.h"

/* x, its magnitude limited. */
SM_INLINE vec_float4 sm_flimit(vec_float4 x, vec_float4 most) {
  return sm_fsel(x, sm_fsigned(most, sm_fsign(x)), sm_igt(sm_fbits(x), (vec_int4)most));
}

/* e^x = (result + 1) * 2^power, for |x| up to 200. */
SM_INLINE vec_float4 sm_fexp_parts(vec_float4 x, vec_int4* power) {
  const vec_int4 k = sm_fnearest(sm_fmul(x, SM_F4(0x1.715476p0f)));
  const vec_float4 multiple = sm_itof(k);
  const vec_float4 high = sm_fnmsub(multiple, SM_F4(0x1.62e4p-1f), x);
  const vec_float4 r = sm_fnmsub(multiple, SM_F4(0x1.7f7d1cp-20f), high);
  *power = k;
  return sm_fmadd(sm_fmul(r, r), sm_poly_exp_f4(r), r);
}

static inline vec_float4 _expf4(vec_float4 x) {
  vec_int4 power;
  const vec_float4 minus_one = sm_fexp_parts(sm_flimit(x, SM_F4(200.0f)), &power);
  return sm_fkeep_nan(sm_fscale(sm_fadd(minus_one, SM_F4(1.0f)), power), x);
}

static inline vec_float4 _exp2f4(vec_float4 x) {
  const vec_float4 limited = sm_flimit(x, SM_F4(300.0f));
  const vec_int4 power = sm_fnearest(limited);
  const vec_float4 r = sm_fsub(limited, sm_itof(power));
  return sm_fkeep_nan(sm_fscale(sm_fmadd(r, sm_poly_exp2_f4(r), SM_F4(1.0f)), power), x);
}

/* (e^r - 1 + 1 - 2^-k) * 2^k; below -25 the result is -1 however that is rounded. */
static inline vec_float4 _expm1f4(vec_float4 x) {
  vec_int4 power;
  const vec_float4 limited = sm_fsel(sm_flimit(x, SM_F4(200.0f)), SM_F4(-20.0f), sm_fgt(SM_F4(-20.0f), x));
  const vec_float4 minus_one = sm_fexp_parts(limited, &power);
  const vec_int4 small = sm_ilimit(power, SM_I4(-40), SM_I4(40));
  const vec_float4 other = sm_fsub(SM_F4(1.0f), sm_fscale(SM_F4(1.0f), -small));
  const vec_float4 sum = sm_fadd(other, minus_one);
  const vec_float4 result = sm_fsel(sm_fscale(sum, power), minus_one, sm_ueq((vec_uint4)power, SM_U4(0)));
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x33000000), sm_fbits(x))), x);
}

#endif
