/* Logarithms. */
#ifndef SPU_EMU_SIMDMATH_F4_LOG_H
#define SPU_EMU_SIMDMATH_F4_LOG_H

#include "simdmath/private/polynomials_f4.h"

/* x = (1 + result) * 2^exponent with the result from sqrt(1/2) - 1 to sqrt(2) - 1, for positive x. */
SM_INLINE vec_float4 sm_flog_parts(vec_float4 x, vec_int4* exponent) {
  vec_int4 whole;
  const vec_float4 part = sm_fsplit(x, &whole);
  const vec_uint4 above = sm_igt((vec_int4)part, SM_I4(0x3fb504f3));
  *exponent = whole - (vec_int4)above;
  return sm_fsub((vec_float4)((vec_uint4)part - (above & SM_U4(1u << 23))), SM_F4(1.0f));
}

/* log(1 + f) - f. */
SM_INLINE vec_float4 sm_flog_tail(vec_float4 f) {
  const vec_float4 square = sm_fmul(f, f);
  return sm_fmadd(sm_fmul(square, f), sm_poly_log_f4(f), sm_fmul(square, SM_F4(-0.5f)));
}

/* The result, but what a logarithm is of zero, negative numbers, infinities and NaNs. */
SM_INLINE vec_float4 sm_flog_of_specials(vec_float4 result, vec_float4 x) {
  vec_float4 known = sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt(SM_I4(0), (vec_int4)x));
  known = sm_fsel(known, (vec_float4)(SM_F_HUGE | SM_F_SIGN), sm_fis_zero(x));
#ifdef __SPU__
  return known;
#else
  return sm_fkeep_nan(sm_fsel(known, x, sm_ueq((vec_uint4)x, SM_F_HUGE)), x);
#endif
}

/* f + tail + exponent * log(2). */
SM_INLINE vec_float4 sm_flog_sum(vec_float4 f, vec_float4 tail, vec_int4 exponent) {
  const vec_float4 e = sm_itof(exponent);
  const vec_float4 small = sm_fadd(f, sm_fmadd(e, SM_F4(-0x1.05c61p-29f), tail));
  return sm_fmadd(e, SM_F4(0x1.62e43p-1f), small);
}

static inline vec_float4 _logf4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 f = sm_flog_parts(x, &exponent);
  return sm_flog_of_specials(sm_flog_sum(f, sm_flog_tail(f), exponent), x);
}

static inline vec_float4 _log2f4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 f = sm_flog_parts(x, &exponent);
  const vec_float4 small = sm_fmadd(sm_flog_tail(f), SM_F4(0x1.715476p0f), sm_fmul(f, SM_F4(0x1.4ae0cp-26f)));
  const vec_float4 fraction = sm_fmadd(f, SM_F4(0x1.715476p0f), small);
  return sm_flog_of_specials(sm_fadd(sm_itof(exponent), fraction), x);
}

static inline vec_float4 _log10f4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 f = sm_flog_parts(x, &exponent);
  const vec_float4 e = sm_itof(exponent);
  const vec_float4 low = sm_fmadd(f, SM_F4(-0x1.5b235ep-27f), sm_fmul(e, SM_F4(-0x1.ec10c0p-27f)));
  const vec_float4 small = sm_fmadd(sm_flog_tail(f), SM_F4(0x1.bcb7b2p-2f), low);
  const vec_float4 fraction = sm_fmadd(f, SM_F4(0x1.bcb7b2p-2f), small);
  return sm_flog_of_specials(sm_fmadd(e, SM_F4(0x1.344136p-2f), fraction), x);
}

/* log(1 + x + low), low being small beside x, without what is special. */
SM_INLINE vec_float4 sm_flog1p(vec_float4 x, vec_float4 low) {
  vec_int4 exponent;
  const vec_float4 one = SM_F4(1.0f);
  const vec_float4 sum = sm_fadd(x, one);
  const vec_float4 lost =
      sm_fsel(sm_fsub(x, sm_fsub(sum, one)), sm_fsub(one, sm_fsub(sum, x)), sm_igt((vec_int4)x, SM_I4(0x3f800000)));
  const vec_float4 parts = sm_flog_parts(sum, &exponent);
  const vec_uint4 direct = sm_igt((vec_int4)SM_F4(0x1.2bp-2f), sm_fbits(x));
  const vec_float4 f = sm_fsel(parts, x, direct);
  const vec_float4 rest = sm_fadd((vec_float4)((vec_uint4)lost & ~direct), low);
  const vec_float4 tail = sm_fmadd(rest, sm_frecip_guess(sum), sm_flog_tail(f));
  return sm_flog_sum(f, tail, (vec_int4)((vec_uint4)exponent & ~direct));
}

static inline vec_float4 _log1pf4(vec_float4 x) {
  const vec_uint4 outside = sm_igt((vec_int4)x & (vec_int4)SM_U4(0x7fffffffu), SM_I4(0x3f800000)) &
                            sm_igt(SM_I4(0), (vec_int4)x);
  const vec_uint4 large = sm_igt((vec_int4)x, (vec_int4)SM_F4(0x1p40f));
  const vec_float4 plain = sm_flog1p(sm_fsel(x, SM_F4(0x1p40f), large), SM_F4(0.0f));
  vec_float4 result = sm_fsel(plain, _logf4(x), large);
  result = sm_fsel(result, (vec_float4)(SM_F_HUGE | SM_F_SIGN), sm_ueq((vec_uint4)x, SM_U4(0xbf800000u)));
  result = sm_fsel(result, (vec_float4)SM_F_NOTHING, outside);
  return sm_fkeep_nan(sm_fsel(result, x, sm_igt(SM_I4(0x33000000), sm_fbits(x))), x);
}

#endif
