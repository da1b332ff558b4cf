/* Quotients and roots of doubles. */
#ifndef SPU_EMU_SIMDMATH_D2_DIVIDE_H
#define SPU_EMU_SIMDMATH_D2_DIVIDE_H

#include "simdmath/private/d2_basic.h"
#include "simdmath/private/f4_divide.h"

#ifdef __SPU__

#include "simdmath/private/polynomials_d2.h"

/* 1 / b for b in the range of floats. */
SM_INLINE vec_double2 sm_dreciprocal(vec_double2 b) {
  const vec_float4 single = sm_dtof(b);
  const vec_float4 guess = sm_frecip_guess(single);
  const vec_double2 y = sm_ftod(sm_fmadd(guess, sm_fnmsub(single, guess, SM_F4(1.0f)), guess));
  const vec_double2 better = sm_dmadd(sm_dnmsub(b, y, SM_D2(1.0)), y, y);
  return sm_dmadd(sm_dnmsub(b, better, SM_D2(1.0)), better, better);
}
SM_INLINE vec_double2 sm_ddivide(vec_double2 a, vec_double2 b) {
  const vec_double2 recip = sm_dreciprocal(b);
  const vec_double2 quotient = sm_dmul(a, recip);
  return sm_dmadd(sm_dnmsub(b, quotient, a), recip, quotient);
}

/* The square root and its reciprocal of x in the range of floats; the mask leaves 0 as it is. */
SM_INLINE vec_double2 sm_dreciprocal_root(vec_double2 x) {
  const vec_float4 single = sm_dtof(x);
  const vec_float4 guess = sm_frsqrt_guess(single);
  const vec_float4 error = sm_fnmsub(sm_fmul(single, guess), guess, SM_F4(1.0f));
  const vec_double2 y = sm_ftod(sm_fmadd(sm_fmul(guess, SM_F4(0.5f)), error, guess));
  const vec_double2 half = SM_D2(0.5);
  return sm_dmadd(sm_dmul(y, half), sm_dnmsub(sm_dmul(x, y), y, SM_D2(1.0)), y);
}
SM_INLINE vec_double2 sm_droot(vec_double2 x) {
  const vec_double2 recip = sm_dreciprocal_root(x);
  const vec_double2 root = sm_dmul(x, recip);
  return sm_dmadd(sm_dmul(recip, SM_D2(0.5)), sm_dnmsub(root, root, x), root);
}

static inline vec_double2 _divd2(vec_double2 a, vec_double2 b) {
  vec_int4 exponent_a, exponent_b;
  const vec_double2 part_a = sm_dsplit(a, &exponent_a);
  const vec_double2 part_b = sm_dsplit(b, &exponent_b);
  const vec_uint4 signs = (sm_dwords(a) ^ sm_dwords(b)) & SM_D_SIGN;
  const vec_double2 quotient = sm_dscale(sm_ddivide(part_a, part_b), exponent_a - exponent_b);
  /* 1 / b of what is zero, infinite or not a number, else 1 with the sign. */
  vec_uint4 recip = spu_sel(sm_dwords(b), sm_dsign(b) | SM_D_ONE, ~sm_dis_special(b));
  recip = spu_sel(recip, sm_dsign(b), sm_dis_infinite(b));
  recip = spu_sel(recip, sm_dsign(b) | SM_D_HUGE, sm_dis_zero(b));
  return sm_dsel(sm_dsigned(quotient, signs), sm_dmul(a, sm_dof(recip)),
                 sm_dis_special(a) | sm_dis_special(b) | sm_dis_zero(a) | sm_dis_zero(b));
}
/* Of a NaN the unit's own, which a product with a constant 1 would not give. */
static inline vec_double2 _recipd2(vec_double2 x) {
  return sm_dkeep_nan(_divd2(SM_D2(1.0), x), x);
}

/* x = part * 4^exponent, part from 1 to below 4. */
SM_INLINE vec_double2 sm_dsplit_even(vec_double2 x, vec_int4* exponent) {
  vec_int4 whole;
  const vec_double2 part = sm_dsplit(x, &whole);
  *exponent = whole >> 1;
  return sm_dof(sm_dwords(part) + (((vec_uint4)whole & SM_HIGH_LOW(1u, 0u)) << 20));
}

static inline vec_double2 _sqrtd2(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 part = sm_dsplit_even(x, &exponent);
  vec_double2 result = sm_dscale(sm_droot(part), exponent);
  result = sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_negative(x));
  result = sm_dsel(result, x, sm_deq_words(sm_dwords(x), SM_D_HUGE));
  return sm_dkeep_nan(sm_dsel(result, sm_dof(sm_dsign(x)), sm_dis_zero(x)), x);
}

static inline vec_double2 _rsqrtd2(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 part = sm_dsplit_even(x, &exponent);
  const vec_double2 recip = sm_dreciprocal_root(part);
  const vec_double2 high = sm_dmul(part, recip);
  const vec_double2 low = sm_dmsub(part, recip, high);
  const vec_double2 error = sm_dnmsub(low, recip, sm_dnmsub(high, recip, SM_D2(1.0)));
  vec_double2 result = sm_dscale(sm_dmadd(sm_dmul(recip, SM_D2(0.5)), error, recip), SM_I4(0) - exponent);
  result = sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_negative(x));
  result = sm_dmasked(result, ~sm_deq_words(sm_dwords(x), SM_D_HUGE));
  return sm_dkeep_nan(sm_dsel(result, sm_dof(SM_D_HUGE), sm_dis_zero(x)), x);
}

static inline vec_double2 _cbrtd2(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 part = sm_dsplit(x, &exponent);
  /* The exponent, made positive, by 3: times 21846 / 65536 is exact in this range. */
  const vec_int4 positive = exponent + SM_I4(1200);
  const vec_int4 third = (positive * SM_I4(21846)) >> 16;
  const vec_int4 rest = positive - third - third - third;
  const vec_double2 whole = sm_dmul(part, sm_dpower_of_two(rest));
  vec_double2 factor = sm_dsel(SM_D2(1.0), SM_D2(0x1.428a2f98d728bp0), sm_igt(rest, SM_I4(0)));
  vec_double2 y, square, low, error, slope, result;
  factor = sm_dsel(factor, SM_D2(0x1.965fea53d6e3dp0), sm_igt(rest, SM_I4(1)));
  y = sm_dmul(sm_poly_cbrt_d2(part), factor);
  slope = sm_dmul(sm_dreciprocal(sm_dmul(y, y)), SM_D2(0x1.5555555555555p-2));
  /* The slope of the guess, with 16 bits, is good enough for three steps. */
  y = sm_dmadd(sm_dnmsub(sm_dmul(y, y), y, whole), slope, y);
  y = sm_dmadd(sm_dnmsub(sm_dmul(y, y), y, whole), slope, y);
  square = sm_dmul(y, y);
  low = sm_dmsub(y, y, square);
  error = sm_dnmsub(low, y, sm_dnmsub(square, y, whole));
  result = sm_dscale(sm_dmadd(error, slope, y), third - SM_I4(400));
  return sm_dsel(sm_dsigned(result, sm_dsign(x)), sm_dadd(x, x), sm_dis_special(x) | sm_dis_zero(x));
}

static inline vec_double2 _hypotd2(vec_double2 x, vec_double2 y) {
  vec_int4 exponent, exponent_b;
  const vec_uint4 y_is_larger = sm_dabsgt(y, x);
  const vec_double2 larger = sm_dabs(sm_dsel(x, y, y_is_larger));
  const vec_double2 smaller = sm_dabs(sm_dsel(y, x, y_is_larger));
  const vec_double2 a = sm_dsplit(larger, &exponent);
  const vec_double2 part_b = sm_dsplit(smaller, &exponent_b);
  const vec_double2 b = sm_dmasked(sm_dscale(part_b, sm_ilimit(exponent_b - exponent, SM_I4(-200), SM_I4(0))),
                                   ~sm_dis_zero(smaller));
  const vec_double2 result = sm_dscale(sm_droot(sm_dmadd(a, a, sm_dmul(b, b))), exponent);
  const vec_double2 known = sm_dsel(result, larger, sm_dis_zero(larger));
  return sm_dsel(sm_dkeep_nan(sm_dkeep_nan(known, x), y), sm_dof(SM_D_HUGE),
                 sm_dis_infinite(x) | sm_dis_infinite(y));
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
