/* Powers. */
#ifndef SPU_EMU_SIMDMATH_F4_POWER_H
#define SPU_EMU_SIMDMATH_F4_POWER_H

#include "simdmath/private/f4_divide.h"
#include "simdmath/private/f4_exp.h"
#include "simdmath/private/f4_log.h"
#include "simdmath/private/f4_round.h"

/* A number as the sum of two. */
typedef struct sm_fpair {
  vec_float4 high;
  vec_float4 low;
} sm_fpair;

/* log2(x) of positive x, with some 31 bits. */
SM_INLINE sm_fpair sm_flog2_pair(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 f = sm_flog_parts(x, &exponent);
  const vec_float4 e = sm_itof(exponent);
  /* s = f / (2 + f); log(1 + f) = 2 atanh(s). */
  const vec_float4 two = SM_F4(2.0f);
  const vec_float4 divisor = sm_fadd(two, f);
  const vec_float4 divisor_low = sm_fsub(f, sm_fsub(divisor, two));
  const vec_float4 s = sm_fdivide(f, divisor);
  const vec_float4 left = sm_fnmsub(s, divisor_low, sm_fnmsub(s, divisor, f));
  const vec_float4 s_low = sm_fmul(left, sm_frecip_guess(divisor));
  const vec_float4 square = sm_fmul(s, s);
  const vec_float4 tail = sm_fmadd(sm_fmul(square, s), sm_poly_atanh_f4(square), s_low);
  const vec_float4 factor = SM_F4(0x1.715476p1f);
  const vec_float4 high = sm_fmul(s, factor);
  const vec_float4 rounding = sm_fneg(sm_fnmsub(s, factor, high));
  const vec_float4 low = sm_fmadd(tail, factor, sm_fmadd(s, SM_F4(0x1.4ae0cp-25f), rounding));
  const vec_float4 sum = sm_fadd(e, high);
  const vec_float4 rest = sm_fadd(low, sm_fsub(high, sm_fsub(sum, e)));
  sm_fpair result;
  result.high = sm_fadd(sum, rest);
  result.low = sm_fsub(rest, sm_fsub(result.high, sum));
  return result;
}

/* |x|^y for what is neither zero nor special. */
SM_INLINE vec_float4 sm_fpower(vec_float4 x, vec_float4 y) {
  const sm_fpair log2 = sm_flog2_pair(sm_fabs(x));
  const vec_float4 exponent = sm_flimit(y, SM_F4(0x1p90f));
  const vec_float4 product = sm_fmul(exponent, log2.high);
  const vec_float4 high = sm_flimit(product, SM_F4(400.0f));
  const vec_uint4 limited = sm_igt(sm_fbits(product), (vec_int4)SM_F4(400.0f));
  const vec_float4 rounding = sm_fnmsub(exponent, log2.high, product);
  const vec_float4 low = sm_fsub(sm_fmul(exponent, log2.low), rounding);
  const vec_int4 power = sm_fnearest(high);
  const vec_float4 r = sm_fadd(sm_fsub(high, sm_itof(power)), (vec_float4)((vec_uint4)low & ~limited));
  return sm_fscale(sm_fmadd(r, sm_poly_exp2_f4(r), SM_F4(1.0f)), power);
}

static inline vec_float4 _powf4(vec_float4 x, vec_float4 y) {
  const vec_uint4 whole = ~sm_fhas_fraction(y);
  const vec_uint4 is_odd_bit = sm_ueq((vec_uint4)sm_ftoi(y) & SM_U4(1), SM_U4(1));
  const vec_uint4 odd = is_odd_bit & whole & sm_igt((vec_int4)SM_F4(0x1p24f), sm_fbits(y));
  const vec_uint4 y_is_negative = (vec_uint4)((vec_int4)y >> 31);
  const vec_uint4 x_is_zero = sm_fis_zero(x);
  const vec_uint4 negative = (vec_uint4)((vec_int4)x >> 31) & ~x_is_zero;
  const vec_uint4 x_is_one = sm_ueq((vec_uint4)x, SM_F_ONE);
  vec_float4 result = sm_fpower(x, y);
  vec_uint4 of_zero = sm_usel(SM_U4(0), SM_F_HUGE, y_is_negative);
#ifndef __SPU__
  const vec_uint4 infinite = sm_ueq((vec_uint4)sm_fabs(x), SM_F_HUGE);
  result = sm_fsel(result, (vec_float4)sm_usel(SM_F_HUGE, SM_U4(0), y_is_negative), infinite);
#endif
  of_zero |= sm_fsign(x) & odd;
  result = (vec_float4)((vec_uint4)result | (SM_F_SIGN & odd & negative & ~sm_fis_zero(result)));
  result = sm_fsel(result, (vec_float4)SM_F_NOTHING, negative & ~(whole | sm_fis_special(x)));
  result = sm_fsel(result, (vec_float4)of_zero, x_is_zero);
  result = sm_fkeep_nan(sm_fkeep_nan(result, x), y);
  return sm_fsel(result, SM_F4(1.0f), sm_fis_zero(y) | x_is_one);
}

#endif
