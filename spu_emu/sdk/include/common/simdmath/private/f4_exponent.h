/* What works on exponents. */
#ifndef SPU_EMU_SIMDMATH_F4_EXPONENT_H
#define SPU_EMU_SIMDMATH_F4_EXPONENT_H

#include "simdmath/private/vectors.h"

/* x = result * 2^exponent, the result's magnitude from 1/2 to below 1. */
static inline vec_float4 _frexpf4(vec_float4 x, vec_int4* exponent) {
  const vec_uint4 as_it_is = sm_fis_zero(x) | sm_fis_special(x);
  const vec_int4 found = sm_fexponent(x) - SM_I4(126);
  const vec_uint4 bits = ((vec_uint4)x & ~SM_F_EXPONENT) | SM_U4(0x3f000000u);
  *exponent = (vec_int4)((vec_uint4)found & ~as_it_is);
#ifdef __SPU__
  return (vec_float4)(bits & ~as_it_is);
#else
  return sm_fsel((vec_float4)bits, sm_fadd(x, x), as_it_is);
#endif
}

static inline vec_float4 _ldexpf4(vec_float4 x, vec_int4 power) {
  vec_int4 exponent;
  const vec_int4 limited = sm_ilimit(power, SM_I4(-1000), SM_I4(1000));
  const vec_float4 fraction = _frexpf4(x, &exponent);
  return sm_fscale(fraction, exponent + limited);
}
static inline vec_float4 _scalbnf4(vec_float4 x, vec_int4 power) { return _ldexpf4(x, power); }

/* The exponent; of zero INT_MIN, on the PPU of infinities and NaNs INT_MAX. */
static inline vec_int4 _ilogbf4(vec_float4 x) {
  const vec_int4 exponent = sm_fexponent(x) - SM_I4(127);
  const vec_uint4 known = sm_usel((vec_uint4)exponent, SM_U4(0x80000000u), sm_fis_zero(x));
  return (vec_int4)sm_usel(known, SM_U4(0x7fffffffu), sm_fis_special(x));
}
static inline vec_float4 _logbf4(vec_float4 x) {
  const vec_float4 exponent = sm_itof(sm_fexponent(x) - SM_I4(127));
  const vec_float4 known = sm_fsel(exponent, (vec_float4)(SM_F_HUGE | SM_F_SIGN), sm_fis_zero(x));
  return sm_fkeep_nan(sm_fsel(known, (vec_float4)SM_F_HUGE, sm_fis_special(x)), x);
}

/* The next number toward y. The next one of zero is the smallest normal number. */
static inline vec_float4 _nextafterf4(vec_float4 x, vec_float4 y) {
  const vec_uint4 zero = sm_fis_zero(x);
  const vec_uint4 up = sm_fgt(y, x);
  const vec_uint4 grows = ~(up ^ ~(vec_uint4)((vec_int4)x >> 31));
  const vec_uint4 step = sm_usel((vec_uint4)x - SM_U4(1), (vec_uint4)x + SM_U4(1), grows);
  const vec_uint4 normal = step & ~sm_ueq(step & SM_F_EXPONENT, SM_U4(0));
  const vec_uint4 from_zero = SM_U4(0x00800000u) | (~up & SM_F_SIGN);
  const vec_float4 next = (vec_float4)sm_usel(normal, from_zero, zero);
  return sm_fkeep_nan(sm_fkeep_nan(sm_fsel(next, y, sm_feq(x, y)), x), y);
}

#endif
