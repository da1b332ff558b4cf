/* Hyperbolic functions of doubles and their inverses. */
#ifndef SPU_EMU_SIMDMATH_D2_HYPERBOLIC_H
#define SPU_EMU_SIMDMATH_D2_HYPERBOLIC_H

#include "simdmath/private/d2_exp_log.h"

#ifdef __SPU__

/* (e^|x| + sign * e^-|x|) / 2. */
SM_INLINE vec_double2 sm_dhalf_sum(vec_double2 x, double sign) {
  vec_int4 power, twice;
  const vec_double2 e = sm_dadd(sm_dexp_parts(sm_dabs(sm_dlimit(x, SM_D2(1000.0))), &power), SM_D2(1.0));
  vec_double2 inverse;
  twice = sm_ilimit(power + power, SM_I4(0), SM_I4(120));
  inverse = sm_dmul(sm_ddivide(SM_D2(1.0), e), sm_dpower_of_two(SM_I4(0) - twice));
  return sm_dscale(sm_dmadd(inverse, SM_D2(sign), e), power - SM_I4(1));
}
static inline vec_double2 _coshd2(vec_double2 x) {
  return sm_dkeep_nan(sm_dhalf_sum(x, 1.0), x);
}

/* Below 1 (t + t / (t + 1)) / 2 with t = e^|x| - 1. */
static inline vec_double2 _sinhd2(vec_double2 x) {
  const vec_uint4 near = sm_dabsgt(SM_D2(1.0), x);
  const vec_double2 t = _expm1d2(sm_dmasked(sm_dabs(x), near));
  const vec_double2 small = sm_dmul(sm_dadd(t, sm_ddivide(t, sm_dadd(t, SM_D2(1.0)))), SM_D2(0.5));
  const vec_double2 result = sm_dsigned(sm_dsel(sm_dhalf_sum(x, -1.0), small, near), sm_dsign(x));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x)), x);
}

/* t / (t + 2) with t = e^2|x| - 1, which is 1 from 32 on. */
static inline vec_double2 _tanhd2(vec_double2 x) {
  const vec_double2 limited = sm_dabs(sm_dlimit(x, SM_D2(32.0)));
  const vec_double2 t = _expm1d2(sm_dadd(limited, limited));
  const vec_double2 result = sm_dsigned(sm_ddivide(t, sm_dadd(t, SM_D2(2.0))), sm_dsign(x));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x)), x);
}

/* log(2 x), for large x. */
SM_INLINE vec_double2 sm_dlog_of_twice(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 f = sm_dlog_parts(x, &exponent);
  return sm_dlog_sum(f, SM_D2(0.0), exponent + SM_I4(1));
}

/* log(1 + |x| + x^2 / (1 + sqrt(1 + x^2))). */
static inline vec_double2 _asinhd2(vec_double2 x) {
  const vec_double2 magnitude = sm_dabs(x);
  const vec_uint4 large = sm_dabsgt(x, SM_D2(0x1p50));
  const vec_double2 limited = sm_dmasked(magnitude, ~large);
  const vec_double2 square = sm_dmul(limited, limited);
  const vec_double2 one = SM_D2(1.0);
  const vec_double2 low = sm_ddivide(square, sm_dadd(one, sm_droot(sm_dadd(one, square))));
  const vec_double2 sum = sm_dadd(limited, low);
  const vec_double2 near = sm_dlog1p(sum, sm_dsub(low, sm_dsub(sum, limited)));
  vec_double2 result = sm_dsel(near, sm_dlog_of_twice(magnitude), large);
  result = sm_dsigned(sm_dsel(result, magnitude, sm_dis_special(x)), sm_dsign(x));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x)), x);
}

/* log(1 + t + sqrt(t (2 + t))) with t = x - 1. */
static inline vec_double2 _acoshd2(vec_double2 x) {
  const vec_uint4 large = sm_dabsgt(x, SM_D2(0x1p50));
  const vec_uint4 inside = spu_andc(sm_dabsgt(x, SM_D2(1.0)), large | sm_dis_negative(x));
  const vec_double2 t = sm_dsub(sm_dsel(SM_D2(2.0), x, inside), SM_D2(1.0));
  const vec_double2 root = sm_droot(sm_dmadd(t, t, sm_dadd(t, t)));
  const vec_double2 sum = sm_dadd(t, root);
  const vec_uint4 above = sm_dabsgt(t, root);
  const vec_double2 lost = sm_dsub(sm_dsel(t, root, above), sm_dsub(sum, sm_dsel(root, t, above)));
  vec_double2 result = sm_dsel(sm_dlog1p(sum, lost), sm_dlog_of_twice(x), large);
  result = sm_dmasked(result, ~sm_deq_words(sm_dwords(x), SM_D_ONE));
  result = sm_dsel(result, x, sm_dis_infinite(x));
  return sm_dkeep_nan(sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_negative(x) | sm_dabsgt(SM_D2(1.0), x)),
                      x);
}

/* log(1 + 2 |x| / (1 - |x|)) / 2. */
static inline vec_double2 _atanhd2(vec_double2 x) {
  const vec_double2 magnitude = sm_dabs(x);
  const vec_double2 one = SM_D2(1.0);
  const vec_double2 limited = sm_dmasked(magnitude, sm_dabsgt(one, x));
  const vec_double2 divisor = sm_dsub(one, limited);
  const vec_double2 twice = sm_dadd(limited, limited);
  const vec_double2 quotient = sm_ddivide(twice, divisor);
  const vec_double2 lost_of_divisor = sm_dsub(sm_dsub(one, divisor), limited);
  const vec_double2 left = sm_dnmsub(quotient, lost_of_divisor, sm_dnmsub(quotient, divisor, twice));
  vec_double2 result = sm_dmul(sm_dlog1p(quotient, sm_dmul(left, sm_dreciprocal(divisor))), SM_D2(0.5));
  result = sm_dsel(result, sm_dof(SM_D_HUGE), sm_deq_words(sm_dwords(magnitude), SM_D_ONE));
  result = sm_dsel(sm_dsigned(result, sm_dsign(x)), sm_dof(SM_D_NOTHING), sm_dabsgt(x, one));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x)), x);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
