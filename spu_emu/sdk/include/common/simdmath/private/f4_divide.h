/* Quotients and roots. On the SPU recipf4, divf4 and sqrtf4 give the exact result rounded toward zero. */
#ifndef SPU_EMU_SIMDMATH_F4_DIVIDE_H
#define SPU_EMU_SIMDMATH_F4_DIVIDE_H

#include "simdmath/private/polynomials_f4.h"

/* a / b where neither b nor the result is near the ends of the range; may be one unit too small. */
SM_INLINE vec_float4 sm_fdivide(vec_float4 a, vec_float4 b) {
  const vec_float4 guess = sm_frecip_guess(b);
  const vec_float4 recip = sm_fmadd(guess, sm_fnmsub(b, guess, SM_F4(1.0f)), guess);
  const vec_float4 quotient = sm_fmul(a, recip);
  return sm_fmadd(recip, sm_fnmsub(b, quotient, a), quotient);
}

/* The square root of x, which is not near the ends of the range; may be one unit too small. */
SM_INLINE vec_float4 sm_froot(vec_float4 x) {
  const vec_float4 guess = sm_frsqrt_guess(x);
  const vec_float4 error = sm_fnmsub(sm_fmul(x, guess), guess, SM_F4(1.0f));
  const vec_float4 recip = sm_fmadd(sm_fmul(guess, SM_F4(0.5f)), error, guess);
  const vec_float4 root = sm_fmul(x, recip);
  return sm_fmadd(sm_fmul(recip, SM_F4(0.5f)), sm_fnmsub(root, root, x), root);
}

/* The same with its last bit on the SPU. */
SM_INLINE vec_float4 sm_froot_exact(vec_float4 x) {
  const vec_float4 root = sm_froot(x);
#ifdef __SPU__
  const vec_float4 next = (vec_float4)((vec_uint4)root + SM_U4(1));
  return sm_fsel(next, root, sm_igt(SM_I4(0), (vec_int4)sm_fnmsub(next, next, x)));
#else
  return root;
#endif
}

/* The result, or its neighbour away from zero where b times that is not more than a: exact but for its last bit. */
SM_INLINE vec_float4 sm_ftruncated_quotient(vec_float4 a, vec_float4 b, vec_float4 quotient) {
#ifdef __SPU__
  const vec_float4 next = (vec_float4)((vec_uint4)quotient + SM_U4(1));
  const vec_uint4 too_large = sm_igt(SM_I4(0), (vec_int4)sm_fnmsub(b, next, a));
  return sm_fsel(next, quotient, too_large);
#else
  (void)a;
  (void)b;
  return quotient;
#endif
}

/* What a quotient is for zeros and, on the PPU, for infinities and NaNs. */
SM_INLINE vec_float4 sm_fquotient_of_specials(vec_float4 result, vec_float4 a, vec_float4 b) {
  const vec_uint4 signs = sm_fsign(a) ^ sm_fsign(b);
#ifdef __SPU__
  const vec_float4 of_a = (vec_float4)((vec_uint4)result & ~sm_fis_zero(a));
  return sm_fsel(of_a, (vec_float4)(SM_F_HUGE | signs), sm_fis_zero(b));
#else
  const vec_uint4 infinite = sm_ueq((vec_uint4)sm_fabs(b), SM_F_HUGE);
  vec_uint4 recip = sm_usel((vec_uint4)b, sm_fsign(b) | SM_F_ONE, ~sm_fis_special(b));
  recip = sm_usel(recip, sm_fsign(b), infinite);
  recip = sm_usel(recip, sm_fsign(b) | SM_F_HUGE, sm_fis_zero(b));
  (void)signs;
  return sm_fsel(result, sm_fmul(a, (vec_float4)recip),
                 sm_fis_special(a) | sm_fis_special(b) | sm_fis_zero(a) | sm_fis_zero(b));
#endif
}

static inline vec_float4 _divf4(vec_float4 a, vec_float4 b) {
  vec_int4 exponent_a, exponent_b;
  const vec_float4 part_a = sm_fsplit(a, &exponent_a);
  const vec_float4 part_b = sm_fsplit(b, &exponent_b);
  const vec_float4 quotient = sm_ftruncated_quotient(part_a, part_b, sm_fdivide(part_a, part_b));
  const vec_float4 scaled = sm_fscale(quotient, exponent_a - exponent_b);
  const vec_uint4 signs = sm_fsign(a) ^ sm_fsign(b);
#ifdef __SPU__
  const vec_float4 result = sm_fsigned(scaled, signs & ~sm_fis_zero(scaled));
#else
  const vec_float4 result = sm_fsigned(scaled, signs);
#endif
  return sm_fquotient_of_specials(result, a, b);
}

static inline vec_float4 _recipf4(vec_float4 x) { return _divf4(SM_F4(1.0f), x); }

/* Without the last bit, and for b and results from 2^-126 to 2^126 in magnitude. */
static inline vec_float4 _divf4_fast(vec_float4 a, vec_float4 b) { return sm_fdivide(a, b); }
static inline vec_float4 _recipf4_fast(vec_float4 x) { return sm_fdivide(SM_F4(1.0f), x); }
/* Without the last bit, and for x from 2^-126 to 2^126. */
static inline vec_float4 _sqrtf4_fast(vec_float4 x) { return sm_froot(x); }

/* x = part * 4^exponent, part from 1 to below 4, for positive normal x. */
SM_INLINE vec_float4 sm_fsplit_even(vec_float4 x, vec_int4* exponent) {
  vec_int4 whole;
  const vec_float4 part = sm_fsplit(x, &whole);
  *exponent = whole >> 1;
  return (vec_float4)((vec_uint4)part + (((vec_uint4)whole & SM_U4(1)) << 23));
}

static inline vec_float4 _sqrtf4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 part = sm_fsplit_even(sm_fabs(x), &exponent);
  vec_float4 result = sm_fscale(sm_froot_exact(part), exponent);
#ifndef __SPU__
  result = sm_fsel(result, x, sm_ueq((vec_uint4)x, SM_F_HUGE));
#endif
  result = sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt(SM_I4(0), (vec_int4)x));
  return sm_fkeep_nan(sm_fsel(result, (vec_float4)sm_fsign(x), sm_fis_zero(x)), x);
}

static inline vec_float4 _rsqrtf4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 part = sm_fsplit_even(sm_fabs(x), &exponent);
  const vec_float4 guess = sm_frsqrt_guess(part);
  const vec_float4 first_error = sm_fnmsub(sm_fmul(part, guess), guess, SM_F4(1.0f));
  const vec_float4 recip = sm_fmadd(sm_fmul(guess, SM_F4(0.5f)), first_error, guess);
  /* part * recip as two numbers, for what is left to be exact enough. */
  const vec_float4 high = sm_fmul(part, recip);
  const vec_float4 low = sm_fneg(sm_fnmsub(part, recip, high));
  const vec_float4 error = sm_fnmsub(low, recip, sm_fnmsub(high, recip, SM_F4(1.0f)));
  vec_float4 result = sm_fmadd(sm_fmul(recip, SM_F4(0.5f)), error, recip);
  result = sm_fscale(result, -exponent);
  result = sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt(SM_I4(0), (vec_int4)x));
#ifndef __SPU__
  result = (vec_float4)((vec_uint4)result & ~sm_ueq((vec_uint4)x, SM_F_HUGE));
#endif
  return sm_fkeep_nan(sm_fsel(result, (vec_float4)SM_F_HUGE, sm_fis_zero(x)), x);
}

static inline vec_float4 _cbrtf4(vec_float4 x) {
  vec_int4 exponent;
  const vec_float4 part = sm_fsplit(sm_fabs(x), &exponent);
  /* The exponent, made positive, by 3: times 21846 / 65536 is exact in this range. */
  const vec_int4 positive = exponent + SM_I4(600);
  const vec_int4 third = (positive * SM_I4(21846)) >> 16;
  const vec_int4 rest = positive - third * SM_I4(3);
  const vec_float4 whole = (vec_float4)((vec_uint4)part + ((vec_uint4)rest << 23));
  vec_float4 factor = sm_fsel(SM_F4(1.0f), SM_F4(0x1.428a3p0f), sm_igt(rest, SM_I4(0)));
  factor = sm_fsel(factor, SM_F4(0x1.965feap0f), sm_igt(rest, SM_I4(1)));
  const vec_float4 guess = sm_fmul(sm_poly_cbrt_f4(part), factor);
  const vec_float4 square = sm_fmul(guess, guess);
  const vec_float4 low = sm_fneg(sm_fnmsub(guess, guess, square));
  const vec_float4 error = sm_fnmsub(low, guess, sm_fnmsub(square, guess, whole));
  const vec_float4 slope = sm_fmul(sm_frecip_guess(square), SM_F4(0x1.555554p-2f));
  vec_float4 result = sm_fmadd(error, slope, guess);
  result = sm_fscale(result, third - SM_I4(200));
#ifdef __SPU__
  return sm_fsigned((vec_float4)((vec_uint4)result & ~sm_fis_zero(x)), sm_fsign(x) & ~sm_fis_zero(x));
#else
  return sm_fsel(sm_fsigned(result, sm_fsign(x)), sm_fadd(x, x), sm_fis_special(x) | sm_fis_zero(x));
#endif
}

static inline vec_float4 _hypotf4(vec_float4 x, vec_float4 y) {
  vec_int4 exponent, exponent_b;
  const vec_uint4 y_is_larger = sm_igt(sm_fbits(y), sm_fbits(x));
  const vec_float4 larger = sm_fabs(sm_fsel(x, y, y_is_larger));
  const vec_float4 smaller = sm_fabs(sm_fsel(y, x, y_is_larger));
  const vec_float4 a = sm_fsplit(larger, &exponent);
  const vec_float4 part_b = sm_fsplit(smaller, &exponent_b);
  const vec_int4 distance = exponent_b - exponent;
  const vec_float4 b =
      (vec_float4)((vec_uint4)sm_fscale(part_b, sm_ilimit(distance, SM_I4(-100), SM_I4(0))) & ~sm_fis_zero(smaller));
  const vec_float4 result = sm_fscale(sm_froot_exact(sm_fmadd(a, a, sm_fmul(b, b))), exponent);
#ifdef __SPU__
  return (vec_float4)((vec_uint4)result & ~sm_fis_zero(larger));
#else
  const vec_uint4 infinite = sm_ueq((vec_uint4)sm_fabs(x), SM_F_HUGE) | sm_ueq((vec_uint4)sm_fabs(y), SM_F_HUGE);
  const vec_float4 known = sm_fsel(result, larger, sm_fis_zero(larger));
  return sm_fsel(sm_fkeep_nan(sm_fkeep_nan(known, x), y), (vec_float4)SM_F_HUGE, infinite);
#endif
}

#endif
