/* Signs, kinds, compares, whole numbers and exponents of doubles. A denormal operand counts as zero, as to
 * the SPU. */
#ifndef SPU_EMU_SIMDMATH_D2_BASIC_H
#define SPU_EMU_SIMDMATH_D2_BASIC_H

#include <math.h>

#include "simdmath/private/doubles.h"

#ifdef __SPU__

SM_INLINE vec_ullong2 sm_dresult(vec_uint4 mask) {
  return (vec_ullong2)(qword)mask;
}
/* An integer in both words as one of 64 bits. */
SM_INLINE vec_llong2 sm_dlong(vec_int4 x) {
  return (vec_llong2)(qword)spu_sel((vec_uint4)(x >> 31), (vec_uint4)x, SM_HIGH_LOW(0u, 0xffffffffu));
}
/* The other way, limited to +-3000; in both words. */
SM_INLINE vec_int4 sm_dlimited(vec_llong2 x) {
  const vec_uint4 words = (vec_uint4)(qword)x;
  const vec_int4 high = (vec_int4)sm_deven(words);
  const vec_int4 low = (vec_int4)sm_dodd(words);
  const vec_uint4 fits = spu_cmpeq(high, low >> 31);
  const vec_uint4 far = spu_sel(SM_U4(3000), SM_U4((unsigned int)-3000), sm_igt(SM_I4(0), high));
  return sm_ilimit((vec_int4)spu_sel(far, (vec_uint4)low, fits), SM_I4(-3000), SM_I4(3000));
}

static inline vec_double2 _fabsd2(vec_double2 x) {
  return sm_dabs(x);
}
static inline vec_double2 _negated2(vec_double2 x) {
  return sm_dneg(x);
}
static inline vec_double2 _copysignd2(vec_double2 x, vec_double2 y) {
  return sm_dsigned(sm_dabs(x), sm_dsign(y));
}
static inline vec_ullong2 _signbitd2(vec_double2 x) {
  return sm_dresult(sm_dis_negative(x));
}
static inline vec_ullong2 _isnand2(vec_double2 x) {
  return sm_dresult(sm_dis_nan(x));
}
static inline vec_ullong2 _isinfd2(vec_double2 x) {
  return sm_dresult(sm_dis_infinite(x));
}
static inline vec_ullong2 _isfinited2(vec_double2 x) {
  return sm_dresult(~sm_dis_special(x));
}
static inline vec_ullong2 _is0denormd2(vec_double2 x) {
  return sm_dresult(sm_dis_zero(x));
}
static inline vec_ullong2 _isnormald2(vec_double2 x) {
  return sm_dresult(~(sm_dis_zero(x) | sm_dis_special(x)));
}

static inline vec_llong2 _fpclassifyd2(vec_double2 x) {
  vec_uint4 kind = spu_sel(SM_U4(FP_NORMAL), SM_U4(FP_SUBNORMAL), sm_dis_zero(x));
  kind = spu_sel(kind, SM_U4(FP_ZERO), sm_deq_words(sm_dmagnitude(x), SM_U4(0)));
  kind = spu_sel(kind, SM_U4(FP_INFINITE), sm_dis_infinite(x));
  return sm_dlong((vec_int4)spu_sel(kind, SM_U4(FP_NAN), sm_dis_nan(x)));
}

static inline vec_ullong2 _isequald2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_deq(x, y));
}
static inline vec_ullong2 _isgreaterd2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_dgt(x, y));
}
static inline vec_ullong2 _isgreaterequald2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_dgt(x, y) | sm_deq(x, y));
}
static inline vec_ullong2 _islessd2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_dgt(y, x));
}
static inline vec_ullong2 _islessequald2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_dgt(y, x) | sm_deq(x, y));
}
static inline vec_ullong2 _islessgreaterd2(vec_double2 x, vec_double2 y) {
  return sm_dresult(sm_dgt(x, y) | sm_dgt(y, x));
}
static inline vec_ullong2 _isunorderedd2(vec_double2 x, vec_double2 y) {
  return sm_dresult(~sm_dordered(x, y));
}
static inline vec_double2 _fmaxd2(vec_double2 x, vec_double2 y) {
  return sm_dsel(x, y, sm_dgt(y, x) | sm_dis_nan(x));
}
static inline vec_double2 _fmind2(vec_double2 x, vec_double2 y) {
  return sm_dsel(x, y, sm_dgt(x, y) | sm_dis_nan(x));
}
static inline vec_double2 _fdimd2(vec_double2 x, vec_double2 y) {
  return sm_dmasked(sm_dsub(x, y), sm_dgt(x, y) | ~sm_dordered(x, y));
}
static inline vec_double2 _fmad2(vec_double2 x, vec_double2 y, vec_double2 z) {
  return sm_dmadd(x, y, z);
}

/* The bits of the fraction part of |x|: all below 1, none from 2^52 on. */
SM_INLINE vec_uint4 sm_dbits_below_one(vec_double2 x) {
  const vec_int4 exponent = sm_ilimit(sm_dexponent(x) - SM_I4(1023), SM_I4(-1), SM_I4(52));
  const vec_int4 of_low = sm_ilimit(exponent - SM_I4(20), SM_I4(0), SM_I4(32));
  const vec_uint4 high = spu_rlmask(SM_U4(0x000fffffu), SM_I4(0) - sm_ilimit(exponent, SM_I4(0), SM_I4(20)));
  const vec_uint4 low = spu_rlmask(SM_U4(0xffffffffu), SM_I4(0) - of_low);
  const vec_uint4 words = spu_sel(high, low, SM_HIGH_LOW(0u, 0xffffffffu));
  return spu_sel(words, ~SM_D_SIGN, sm_igt(SM_I4(0), exponent));
}
SM_INLINE vec_uint4 sm_dhas_fraction(vec_double2 x) {
  return ~(sm_deq_words(sm_dwords(x) & sm_dbits_below_one(x), SM_U4(0)) | sm_dis_zero(x));
}

static inline vec_double2 _truncd2(vec_double2 x) {
  return sm_dof(spu_andc(sm_dwords(x), sm_dbits_below_one(x)));
}

/* The whole part, one further from zero where the mask says so, with the sign of x. */
SM_INLINE vec_double2 sm_dtruncated_and_one(vec_double2 x, vec_uint4 mask) {
  const vec_double2 whole = _truncd2(x);
  const vec_double2 one = sm_dof(SM_D_ONE | sm_dsign(x));
  return sm_dsel(whole, sm_dadd(whole, one), mask);
}
static inline vec_double2 _floord2(vec_double2 x) {
  return sm_dtruncated_and_one(x, sm_dhas_fraction(x) & sm_dis_negative(x));
}
static inline vec_double2 _ceild2(vec_double2 x) {
  return sm_dtruncated_and_one(x, spu_andc(sm_dhas_fraction(x), sm_dis_negative(x)));
}
static inline vec_double2 _roundd2(vec_double2 x) {
  const vec_double2 fraction = sm_dsub(x, _truncd2(x));
  return sm_dtruncated_and_one(x, sm_dhas_fraction(x) & ~sm_dabsgt(SM_D2(0.5), fraction));
}
/* In the rounding of the FPSCR, which is to the nearest unless the program sets it. */
static inline vec_double2 _rintd2(vec_double2 x) {
  const vec_uint4 signs = sm_dsign(x);
  const vec_double2 large = sm_dsigned(SM_D2(0x1p52), signs);
  const vec_double2 rounded = sm_dsigned(sm_dabs(sm_dsub(sm_dadd(x, large), large)), signs);
  return sm_dsel(sm_dkeep_nan(x, x), rounded, sm_dabsgt(SM_D2(0x1p52), x));
}
static inline vec_double2 _nearbyintd2(vec_double2 x) {
  return _rintd2(x);
}

/* A double that is whole as a 64-bit number, limited to what that holds. */
SM_INLINE long long sm_dwhole_to_ll(unsigned int high, unsigned int low) {
  const int power = (int)(high >> 20 & 2047u) - 1075;
  const unsigned long long significand = ((unsigned long long)((high & 0xfffffu) | 0x100000u) << 32) | low;
  unsigned long long magnitude;
  if (power >= 11) return high >> 31 != 0 ? -0x7fffffffffffffffLL - 1 : 0x7fffffffffffffffLL;
  if (power < -52) return 0;
  magnitude = power >= 0 ? significand << power : significand >> -power;
  return high >> 31 != 0 ? (long long)(0 - magnitude) : (long long)magnitude;
}
SM_INLINE vec_llong2 sm_dwholes_to_ll(vec_double2 x) {
  const vec_uint4 words = sm_dwords(x);
  return (vec_llong2){sm_dwhole_to_ll(spu_extract(words, 0), spu_extract(words, 1)),
                      sm_dwhole_to_ll(spu_extract(words, 2), spu_extract(words, 3))};
}
static inline vec_llong2 _llrintd2(vec_double2 x) {
  return sm_dwholes_to_ll(_rintd2(x));
}
static inline vec_llong2 _llroundd2(vec_double2 x) {
  return sm_dwholes_to_ll(_roundd2(x));
}

static inline vec_double2 _modfd2(vec_double2 x, vec_double2* whole) {
  const vec_double2 truncated = _truncd2(x);
  const vec_double2 rest = sm_dsub(x, truncated);
  *whole = sm_dkeep_nan(truncated, x);
  return sm_dsigned(sm_dmasked(rest, sm_dhas_fraction(x) | sm_dis_nan(x)), sm_dsign(x));
}

/* x = result * 2^exponent, the result's magnitude from 1/2 to below 1. */
SM_INLINE vec_double2 sm_dfrexp(vec_double2 x, vec_int4* exponent) {
  const vec_uint4 as_it_is = sm_dis_zero(x) | sm_dis_special(x);
  const vec_double2 half =
      sm_dof((sm_dwords(x) & (SM_D_FRACTION | SM_D_SIGN)) | SM_HIGH_LOW(0x3fe00000u, 0u));
  *exponent = (vec_int4)spu_andc((vec_uint4)(sm_dexponent(x) - SM_I4(1022)), as_it_is);
  return sm_dsel(half, sm_dadd(x, x), as_it_is);
}
static inline vec_double2 _frexpd2(vec_double2 x, vec_llong2* exponent) {
  vec_int4 power;
  const vec_double2 fraction = sm_dfrexp(x, &power);
  *exponent = sm_dlong(power);
  return fraction;
}
static inline vec_double2 _ldexpd2(vec_double2 x, vec_llong2 power) {
  vec_int4 exponent;
  const vec_double2 fraction = sm_dfrexp(x, &exponent);
  return sm_dscale(fraction, exponent + sm_dlimited(power));
}
static inline vec_double2 _scalbllnd2(vec_double2 x, vec_llong2 power) {
  return _ldexpd2(x, power);
}

/* The exponent; of zero the smallest int, of infinities and NaNs the largest. */
static inline vec_llong2 _ilogbd2(vec_double2 x) {
  vec_uint4 exponent = (vec_uint4)(sm_dexponent(x) - SM_I4(1023));
  exponent = spu_sel(exponent, SM_U4(0x80000000u), sm_dis_zero(x));
  return sm_dlong((vec_int4)spu_sel(exponent, SM_U4(0x7fffffffu), sm_dis_special(x)));
}
static inline vec_double2 _logbd2(vec_double2 x) {
  const vec_double2 exponent = sm_ditod(sm_dexponent(x) - SM_I4(1023));
  const vec_double2 known = sm_dsel(exponent, sm_dof(SM_D_HUGE | SM_D_SIGN), sm_dis_zero(x));
  return sm_dkeep_nan(sm_dsel(known, sm_dof(SM_D_HUGE), sm_dis_special(x)), x);
}

/* The next number toward y that is not denormal. */
static inline vec_double2 _nextafterd2(vec_double2 x, vec_double2 y) {
  const vec_uint4 up = sm_dgt(y, x);
  const vec_uint4 grows = up ^ sm_dis_negative(x);
  const vec_ullong2 bits = (vec_ullong2)(qword)sm_dwords(x);
  const vec_uint4 larger = (vec_uint4)(qword)(bits + (vec_ullong2){1, 1});
  const vec_uint4 smaller = (vec_uint4)(qword)(bits - (vec_ullong2){1, 1});
  const vec_uint4 step = spu_sel(smaller, larger, grows);
  const vec_uint4 normal = spu_andc(step, sm_dis_zero(sm_dof(step)));
  const vec_uint4 from_zero = SM_HIGH_LOW(0x00100000u, 0u) | spu_andc(SM_D_SIGN, up);
  const vec_double2 next = sm_dof(spu_sel(normal, from_zero, sm_dis_zero(x)));
  return sm_dkeep_nan(sm_dkeep_nan(sm_dsel(next, y, sm_deq(x, y)), x), y);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
