/* To whole numbers. */
#ifndef SPU_EMU_SIMDMATH_F4_ROUND_H
#define SPU_EMU_SIMDMATH_F4_ROUND_H

#include "simdmath/private/vectors.h"

/* The bits of the fraction part of |x|: all below 1, none from 2^23 on. */
SM_INLINE vec_uint4 sm_fbits_below_one(vec_float4 x) {
  const vec_int4 exponent = sm_ilimit(sm_fexponent(x), SM_I4(127), SM_I4(150)) - SM_I4(127);
#ifdef __SPU__
  const vec_uint4 bits = spu_rlmask(SM_F_FRACTION, SM_I4(0) - exponent);
#else
  const vec_uint4 bits = vec_sr(SM_F_FRACTION, (vec_uint4)exponent);
#endif
  return sm_usel(bits, SM_F_MAGNITUDE, sm_igt(SM_I4(0x3f800000), sm_fbits(x)));
}

static inline vec_float4 _truncf4(vec_float4 x) {
  return (vec_float4)((vec_uint4)x & ~sm_fbits_below_one(x));
}

/* The whole part, one further from zero where the mask says so; a sum of whole numbers is exact. */
SM_INLINE vec_float4 sm_ftruncated_and_one(vec_float4 x, vec_uint4 mask) {
  const vec_float4 whole = _truncf4(x);
  const vec_float4 one = (vec_float4)((SM_F_ONE | sm_fsign(x)) & mask);
  return sm_fsel(whole, sm_fadd(whole, one), mask);
}

SM_INLINE vec_uint4 sm_fhas_fraction(vec_float4 x) {
  return ~sm_ueq((vec_uint4)x & sm_fbits_below_one(x) & SM_F_MAGNITUDE, SM_U4(0)) & ~sm_fis_zero(x);
}

static inline vec_float4 _floorf4(vec_float4 x) {
  return sm_ftruncated_and_one(x, sm_fhas_fraction(x) & (vec_uint4)((vec_int4)x >> 31));
}
static inline vec_float4 _ceilf4(vec_float4 x) {
  return sm_ftruncated_and_one(x, sm_fhas_fraction(x) & ~(vec_uint4)((vec_int4)x >> 31));
}

/* Halves away from zero: where the highest bit of the fraction part is set. */
static inline vec_float4 _roundf4(vec_float4 x) {
  const vec_uint4 fraction = sm_fbits_below_one(x);
  const vec_uint4 half_bit = fraction & ~(fraction >> 1);
  const vec_uint4 small = sm_igt(SM_I4(0x3f800000), sm_fbits(x));
  const vec_uint4 half =
      sm_usel(~sm_ueq((vec_uint4)x & half_bit, SM_U4(0)), sm_igt(sm_fbits(x), SM_I4(0x3effffff)), small);
  return sm_ftruncated_and_one(x, half);
}

/* In the rounding of the unit: toward zero on the SPU, halves to even on the PPU. */
static inline vec_float4 _rintf4(vec_float4 x) {
#ifdef __SPU__
  return _truncf4(x);
#else
  return sm_fsigned(sm_fabs(vec_round(x)), sm_fsign(x));
#endif
}
static inline vec_float4 _nearbyintf4(vec_float4 x) {
  return _rintf4(x);
}
static inline vec_int4 _irintf4(vec_float4 x) {
  return sm_ftoi(_rintf4(x));
}
static inline vec_int4 _iroundf4(vec_float4 x) {
  return sm_ftoi(_roundf4(x));
}

/* A float that is whole as a 64-bit number, limited to what that holds. */
SM_INLINE long long sm_whole_to_ll(unsigned int bits) {
  const int power = (int)(bits >> 23 & 255u) - 150;
  const unsigned long long significand = (bits & 0x7fffffu) | 0x800000u;
  unsigned long long magnitude;
  if (power >= 40) return bits >> 31 != 0 ? -0x7fffffffffffffffLL - 1 : 0x7fffffffffffffffLL;
  if (power < -24) return 0;
  magnitude = power >= 0 ? significand << power : significand >> -power;
  return bits >> 31 != 0 ? (long long)(0 - magnitude) : (long long)magnitude;
}

SM_INLINE llroundf4_t sm_wholes_to_ll(vec_float4 x) {
  union {
    vec_float4 all;
    unsigned int element[4];
  } in;
  llroundf4_t result;
  in.all = x;
  result.vll[0] = sm_ll2(sm_whole_to_ll(in.element[0]), sm_whole_to_ll(in.element[1]));
  result.vll[1] = sm_ll2(sm_whole_to_ll(in.element[2]), sm_whole_to_ll(in.element[3]));
  return result;
}

static inline llroundf4_t _llrintf4(vec_float4 x) {
  return sm_wholes_to_ll(_rintf4(x));
}
static inline llroundf4_t _llroundf4(vec_float4 x) {
  return sm_wholes_to_ll(_roundf4(x));
}

#ifdef __SPU__

/* For magnitudes below 2^31. */
static inline vec_float4 _floorf4_fast(vec_float4 x) {
  const vec_int4 whole = sm_ftoi(x);
  return sm_itof(whole + (vec_int4)sm_fgt(sm_itof(whole), x));
}
static inline vec_float4 _ceilf4_fast(vec_float4 x) {
  const vec_int4 whole = sm_ftoi(x);
  return sm_itof(whole - (vec_int4)sm_fgt(x, sm_itof(whole)));
}

#endif

static inline vec_float4 _modff4(vec_float4 x, vec_float4* whole) {
  const vec_float4 truncated = _truncf4(x);
  const vec_float4 rest = sm_fsub(x, truncated);
  *whole = truncated;
#ifdef __SPU__
  return (vec_float4)((vec_uint4)rest & sm_fhas_fraction(x));
#else
  return sm_fsel(sm_fsigned(sm_fabs(rest), sm_fsign(x)), sm_fsigned(SM_F4(0.0f), sm_fsign(x)),
                 sm_ueq((vec_uint4)sm_fabs(x), SM_F_HUGE));
#endif
}

#endif
