/* Remainders, exact. */
#ifndef SPU_EMU_SIMDMATH_F4_REMAINDER_H
#define SPU_EMU_SIMDMATH_F4_REMAINDER_H

#include "simdmath/private/f4_divide.h"
#include "simdmath/private/f4_round.h"

/* |x| = (quotient * divisor + rest) * 2^exponent, |y| = divisor * 2^exponent, with the last bits of the quotient. */
typedef struct sm_fdivision {
  vec_uint4 quotient;
  vec_uint4 rest;
  vec_uint4 divisor;
  vec_int4 exponent;
} sm_fdivision;

SM_INLINE sm_fdivision sm_flong_division(vec_float4 x, vec_float4 y) {
  const vec_int4 exponent_x = sm_fexponent(x);
  const vec_int4 exponent_y = sm_fexponent(y);
  const vec_uint4 closer = sm_igt(exponent_y, exponent_x);
  const vec_uint4 hidden = SM_U4(0x800000u);
  vec_int4 steps = exponent_x - exponent_y;
  sm_fdivision d;
  d.quotient = SM_U4(0);
  d.rest = ((vec_uint4)x & SM_F_FRACTION) | hidden;
  d.divisor = ((vec_uint4)y & SM_F_FRACTION) | hidden;
  /* An x with the smaller exponent is the rest itself, with its own exponent; from two less it is below half of y. */
  d.exponent = (vec_int4)sm_usel((vec_uint4)exponent_y, (vec_uint4)exponent_x, closer);
  d.divisor = sm_usel(d.divisor, sm_usel(SM_U4(0x7fffffffu), d.divisor << 1, sm_igt(steps, SM_I4(-2))), closer);
  steps = (vec_int4)((vec_uint4)steps & ~(sm_fis_special(x) | sm_fis_special(y)));
  for (; sm_any(sm_igt(steps, SM_I4(-1))); steps -= SM_I4(1)) {
    const vec_uint4 active = sm_igt(steps, SM_I4(-1));
    const vec_uint4 fits = active & ~sm_ugt(d.divisor, d.rest);
    d.rest -= d.divisor & fits;
    d.quotient = sm_usel(d.quotient, (d.quotient << 1) - (vec_uint4)(vec_int4)fits, active);
    d.rest = sm_usel(d.rest, d.rest << 1, sm_igt(steps, SM_I4(0)));
  }
  return d;
}

SM_INLINE vec_float4 sm_frest(vec_uint4 rest, vec_int4 exponent, vec_uint4 signs) {
  const vec_float4 value = sm_fscale(sm_itof((vec_int4)rest), exponent - SM_I4(150));
#ifdef __SPU__
  return sm_fsigned(value, signs & ~sm_fis_zero(value));
#else
  return sm_fsigned(value, signs);
#endif
}

/* A remainder by zero, or of an infinity of the PPU, is none. */
SM_INLINE vec_float4 sm_fremainder_of_specials(vec_float4 result, vec_float4 x, vec_float4 y) {
  const vec_uint4 none = sm_fis_zero(y) | sm_fis_special(x);
#ifdef __SPU__
  return sm_fsel((vec_float4)((vec_uint4)result & ~sm_fis_zero(x)), (vec_float4)SM_F_NOTHING, none);
#else
  vec_float4 known = sm_fsel(result, x, sm_fis_zero(x) | sm_fis_special(y));
  known = sm_fsel(known, (vec_float4)SM_F_NOTHING, none);
  return sm_fkeep_nan(sm_fkeep_nan(known, x), y);
#endif
}

static inline vec_float4 _fmodf4(vec_float4 x, vec_float4 y) {
  const sm_fdivision d = sm_flong_division(x, y);
  return sm_fremainder_of_specials(sm_frest(d.rest, d.exponent, sm_fsign(x)), x, y);
}

#ifdef __SPU__
/* For quotients below 2^23, whose last bit may come from the division. */
static inline vec_float4 _fmodf4_fast(vec_float4 x, vec_float4 y) {
  const vec_float4 divisor = sm_fabs(y);
  const vec_float4 magnitude = sm_fabs(x);
  const vec_float4 quotient = _truncf4(sm_fdivide(magnitude, divisor));
  const vec_float4 rest = sm_fnmsub(quotient, divisor, magnitude);
  const vec_float4 once_more = sm_fsub(rest, divisor);
  return sm_fsigned(sm_fsel(once_more, rest, sm_fgt(divisor, rest)), sm_fsign(x));
}
#endif

/* The quotient is the nearest, of two the even one; three of its bits come back, with its sign. */
static inline vec_float4 _remquof4(vec_float4 x, vec_float4 y, vec_int4* quotient) {
  const sm_fdivision d = sm_flong_division(x, y);
  const vec_uint4 twice = d.rest << 1;
  const vec_uint4 odd = sm_ueq(d.quotient & SM_U4(1), SM_U4(1));
  const vec_uint4 up = sm_ugt(twice, d.divisor) | (sm_ueq(twice, d.divisor) & odd);
  const vec_uint4 rest = sm_usel(d.rest, d.divisor - d.rest, up);
  const vec_uint4 none = sm_fis_zero(y) | sm_fis_zero(x) | sm_fis_special(x) | sm_fis_special(y);
  const vec_uint4 bits = (d.quotient - up) & SM_U4(7) & ~none;
  const vec_uint4 negative = (vec_uint4)((vec_int4)((vec_uint4)x ^ (vec_uint4)y) >> 31);
  *quotient = (vec_int4)((bits ^ negative) - negative);
  return sm_fremainder_of_specials(sm_frest(rest, d.exponent, sm_fsign(x) ^ (up & SM_F_SIGN)), x, y);
}

static inline vec_float4 _remainderf4(vec_float4 x, vec_float4 y) {
  vec_int4 quotient;
  return _remquof4(x, y, &quotient);
}

#endif
