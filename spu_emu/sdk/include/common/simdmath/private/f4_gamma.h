/* The gamma function and the logarithm of its magnitude, by doubles: near the zeros of the logarithm nothing
 * less is exact enough. */
#ifndef SPU_EMU_SIMDMATH_F4_GAMMA_H
#define SPU_EMU_SIMDMATH_F4_GAMMA_H

#include "simdmath/private/vectors.h"

#ifdef __SPU__

#include "simdmath/private/d2_gamma.h"

/* The even elements as doubles. From 2^24 on every float is whole and its gamma is known, so limit it. */
SM_INLINE vec_double2 sm_fto_gamma(vec_float4 x) {
  const vec_uint4 far = sm_igt(sm_fbits(x), (vec_int4)SM_F4(0x1p126f));
  return sm_ftod(sm_fsel(x, sm_fsigned(SM_F4(0x1p126f), sm_fsign(x)), far));
}
/* Doubles as floats in the even elements: beyond their range the largest number or zero. */
SM_INLINE vec_float4 sm_fof_doubles(vec_double2 x) {
  const vec_uint4 large = sm_dabsgt(x, SM_D2(0x1p100));
  const vec_uint4 huge = sm_dabsgt(x, SM_D2(0x1.ffffffp128));
  const vec_uint4 small = sm_dabsgt(SM_D2(0x1p-126), x);
  const vec_double2 scaled =
      sm_dmul(sm_dmasked(x, ~(huge | small)), sm_dsel(SM_D2(1.0), SM_D2(0x1p-8), large));
  const vec_float4 single = sm_dtof(scaled);
  const vec_float4 result = (vec_float4)((vec_uint4)single + (large & ~huge & SM_U4(8u << 23)));
  return sm_fsel(result, (vec_float4)((vec_uint4)sm_fsign((vec_float4)sm_dwords(x)) | SM_F_HUGE), huge);
}
/* The elements to the left, and even elements of two vectors as one. */
SM_INLINE vec_float4 sm_fnext(vec_float4 x) {
  return spu_rlqwbyte(x, 4);
}
SM_INLINE vec_float4 sm_fmerge(vec_float4 even, vec_float4 odd) {
  return spu_shuffle(even, odd, SM_BYTES(0, 1, 2, 3, 16, 17, 18, 19, 8, 9, 10, 11, 24, 25, 26, 27));
}

static inline vec_float4 _lgammaf4(vec_float4 x) {
  vec_float4 parts[2];
  int i;
  parts[0] = x;
  parts[1] = sm_fnext(x);
  for (i = 0; i < 2; ++i) parts[i] = sm_fof_doubles(_lgammad2(sm_fto_gamma(parts[i])));
  return sm_fmerge(parts[0], parts[1]);
}

static inline vec_float4 _tgammaf4(vec_float4 x) {
  vec_float4 parts[2];
  int i;
  parts[0] = x;
  parts[1] = sm_fnext(x);
  for (i = 0; i < 2; ++i) parts[i] = sm_fof_doubles(_tgammad2(sm_fto_gamma(parts[i])));
  return sm_fmerge(parts[0], parts[1]);
}

#else

SM_INLINE float sm_lgamma_of(float x) {
  int sign;
  return (float)__builtin_lgamma_r(x, &sign);
}
#define SM_F4_BY(function, x) ((vec_float4){function(x[0]), function(x[1]), function(x[2]), function(x[3])})

/* Doubles do not flush denormals as AltiVec does. */
SM_INLINE vec_float4 sm_fflush(vec_float4 x) {
  return (vec_float4)((vec_uint4)x & ~(sm_fis_zero(x) & SM_F_MAGNITUDE));
}
static inline vec_float4 _lgammaf4(vec_float4 x) {
  const vec_float4 operand = sm_fflush(x);
  return sm_fflush(SM_F4_BY(sm_lgamma_of, operand));
}
static inline vec_float4 _tgammaf4(vec_float4 x) {
  const vec_float4 operand = sm_fflush(x);
  return sm_fflush(SM_F4_BY((float)__builtin_tgamma, operand));
}

#endif

#endif
