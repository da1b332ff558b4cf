/* Hyperbolic functions and their inverses. */
#ifndef SPU_EMU_SIMDMATH_F4_HYPERBOLIC_H
#define SPU_EMU_SIMDMATH_F4_HYPERBOLIC_H

#include "simdmath/private/f4_divide.h"
#include "simdmath/private/f4_exp.h"
#include "simdmath/private/f4_log.h"

/* (e^|x| + sign * e^-|x|) / 2. */
SM_INLINE vec_float4 sm_fhalf_sum(vec_float4 x, float sign) {
  vec_int4 power;
  const vec_float4 e = sm_fadd(sm_fexp_parts(sm_fsel(sm_fabs(x), SM_F4(200.0f),
                                                     sm_igt(sm_fbits(x), (vec_int4)SM_F4(200.0f))),
                                             &power),
                               SM_F4(1.0f));
  /* e^-|x| / e^|x| * e, which is nothing from 2^-28 on. */
  const vec_int4 twice = sm_ilimit(power + power, SM_I4(0), SM_I4(60));
  const vec_float4 inverse = sm_fscale(sm_fdivide(SM_F4(1.0f), e), -twice);
  return sm_fscale(sm_fmadd(inverse, SM_F4(sign), e), power - SM_I4(1));
}

static inline vec_float4 _coshf4(vec_float4 x) { return sm_fkeep_nan(sm_fhalf_sum(x, 1.0f), x); }

static inline vec_float4 _sinhf4(vec_float4 x) {
  const vec_uint4 near = sm_igt(SM_I4(0x3f800000), sm_fbits(x));
  const vec_float4 small = (vec_float4)((vec_uint4)x & near);
  const vec_float4 square = sm_fmul(small, small);
  const vec_float4 odd = sm_fmadd(sm_fmul(small, square), sm_poly_sinh_f4(square), small);
  const vec_float4 far = sm_fsigned(sm_fhalf_sum(x, -1.0f), sm_fsign(x));
  const vec_float4 result = sm_fsel(far, odd, near);
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x39000000), sm_fbits(x))), x);
}

/* 1 - 2 / (e^2|x| + 1), which is 1 from 16 on. */
static inline vec_float4 _tanhf4(vec_float4 x) {
  vec_int4 power;
  const vec_uint4 near = sm_igt((vec_int4)SM_F4(0.625f), sm_fbits(x));
  const vec_float4 small = (vec_float4)((vec_uint4)x & near);
  const vec_float4 square = sm_fmul(small, small);
  const vec_float4 odd = sm_fmadd(sm_fmul(small, square), sm_poly_tanh_f4(square), small);
  const vec_float4 limited = sm_fsel(sm_fabs(x), SM_F4(16.0f), sm_igt(sm_fbits(x), (vec_int4)SM_F4(16.0f)));
  const vec_float4 e = sm_fadd(sm_fexp_parts(sm_fadd(limited, limited), &power), SM_F4(1.0f));
  const vec_float4 sum = sm_fadd(sm_fscale(e, power), SM_F4(1.0f));
  const vec_float4 far = sm_fsub(SM_F4(1.0f), sm_fdivide(SM_F4(2.0f), sum));
  const vec_float4 result = sm_fsel(sm_fsigned(far, sm_fsign(x)), odd, near);
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x39000000), sm_fbits(x))), x);
}

/* log(2 x), for large x. */
SM_INLINE vec_float4 sm_flog_of_twice(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 f = sm_flog_parts(x, &exponent);
  return sm_flog_sum(f, sm_flog_tail(f), exponent + SM_I4(1));
}

/* log(1 + |x| + x^2 / (1 + sqrt(1 + x^2))). */
static inline vec_float4 _asinhf4(vec_float4 x) {
  const vec_float4 magnitude = sm_fabs(x);
  const vec_uint4 large = sm_igt((vec_int4)magnitude, (vec_int4)SM_F4(0x1p30f));
  const vec_float4 limited = (vec_float4)((vec_uint4)magnitude & ~large);
  const vec_float4 square = sm_fmul(limited, limited);
  const vec_float4 one = SM_F4(1.0f);
  const vec_float4 low = sm_fdivide(square, sm_fadd(one, sm_froot(sm_fadd(one, square))));
  const vec_float4 sum = sm_fadd(limited, low);
  const vec_float4 near = sm_flog1p(sum, sm_fsub(low, sm_fsub(sum, limited)));
  vec_float4 result = sm_fsel(near, sm_flog_of_twice(magnitude), large);
#ifndef __SPU__
  result = sm_fsel(result, magnitude, sm_fis_special(x));
#endif
  result = sm_fsigned(result, sm_fsign(x));
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x39000000), sm_fbits(x))), x);
}

/* log(1 + t + sqrt(t (2 + t))) with t = x - 1. */
static inline vec_float4 _acoshf4(vec_float4 x) {
  const vec_uint4 large = sm_igt((vec_int4)x, (vec_int4)SM_F4(0x1p30f));
  const vec_uint4 inside = sm_igt((vec_int4)x, SM_I4(0x3f800000));
  const vec_float4 t = sm_fsub(sm_fsel(SM_F4(2.0f), x, inside & ~large), SM_F4(1.0f));
  const vec_float4 root = sm_froot(sm_fmadd(t, t, sm_fadd(t, t)));
  const vec_float4 sum = sm_fadd(t, root);
  const vec_uint4 above = sm_fgt(t, root);
  const vec_float4 bigger = sm_fsel(root, t, above);
  const vec_float4 lost = sm_fsub(sm_fsel(t, root, above), sm_fsub(sum, bigger));
  vec_float4 result = sm_fsel(sm_flog1p(sum, lost), sm_flog_of_twice(x), large);
  result = (vec_float4)((vec_uint4)result & ~sm_ueq((vec_uint4)x, SM_F_ONE));
#ifndef __SPU__
  result = sm_fsel(result, x, sm_ueq((vec_uint4)x, SM_F_HUGE));
#endif
  return sm_fkeep_nan(sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt(SM_I4(0x3f800000), (vec_int4)x)), x);
}

/* log(1 + 2 |x| / (1 - |x|)) / 2. */
static inline vec_float4 _atanhf4(vec_float4 x) {
  const vec_float4 magnitude = sm_fabs(x);
  const vec_uint4 inside = sm_igt(SM_I4(0x3f800000), (vec_int4)magnitude);
  const vec_float4 limited = (vec_float4)((vec_uint4)magnitude & inside);
  const vec_float4 divisor = sm_fsub(SM_F4(1.0f), limited);
  const vec_float4 twice = sm_fadd(limited, limited);
  const vec_float4 quotient = sm_fdivide(twice, divisor);
  const vec_float4 left = sm_fnmsub(quotient, divisor, twice);
  const vec_float4 lost_of_divisor = sm_fsub(sm_fsub(SM_F4(1.0f), divisor), limited);
  const vec_float4 low =
      sm_fmul(sm_fnmsub(quotient, lost_of_divisor, left), sm_frecip_guess(divisor));
  vec_float4 result = sm_fmul(sm_flog1p(quotient, low), SM_F4(0.5f));
  result = sm_fsel(result, (vec_float4)SM_F_HUGE, sm_ueq((vec_uint4)magnitude, SM_F_ONE));
  result = sm_fsigned(result, sm_fsign(x));
  result = sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt((vec_int4)magnitude, SM_I4(0x3f800000)));
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x39000000), (vec_int4)magnitude)), x);
}

#endif
