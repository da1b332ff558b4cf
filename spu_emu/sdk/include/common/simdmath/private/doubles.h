/* What the SIMD math library asks of the SPU for double2. A double is worked on as its two words, the high one in the even
 * elements; compares are made of integers, for an SPU of the first Cell has none for doubles. */
#ifndef SPU_EMU_SIMDMATH_DOUBLES_H
#define SPU_EMU_SIMDMATH_DOUBLES_H

#include "simdmath/private/vectors.h"

#ifdef __SPU__

#define SM_D2(c) ((vec_double2){(c), (c)})
#define SM_BYTES(...) ((vec_uchar16){__VA_ARGS__})
/* The words of both doubles: high, low, high, low. */
#define SM_HIGH_LOW(high, low) ((vec_uint4){(high), (low), (high), (low)})

#define SM_D_SIGN SM_HIGH_LOW(0x80000000u, 0u)
#define SM_D_ONE SM_HIGH_LOW(0x3ff00000u, 0u)
#define SM_D_HUGE SM_HIGH_LOW(0x7ff00000u, 0u)
#define SM_D_NOTHING SM_HIGH_LOW(0x7ff80000u, 0u)
#define SM_D_FRACTION SM_HIGH_LOW(0x000fffffu, 0xffffffffu)

SM_INLINE vec_uint4 sm_dwords(vec_double2 x) { return (vec_uint4)(qword)x; }
SM_INLINE vec_double2 sm_dof(vec_uint4 words) { return (vec_double2)(qword)words; }

SM_INLINE vec_double2 sm_dadd(vec_double2 a, vec_double2 b) { return spu_add(a, b); }
SM_INLINE vec_double2 sm_dsub(vec_double2 a, vec_double2 b) { return spu_sub(a, b); }
SM_INLINE vec_double2 sm_dmul(vec_double2 a, vec_double2 b) { return spu_mul(a, b); }
/* a * b + c, a * b - c, and c - a * b, rounded once. */
SM_INLINE vec_double2 sm_dmadd(vec_double2 a, vec_double2 b, vec_double2 c) { return spu_madd(a, b, c); }
SM_INLINE vec_double2 sm_dmsub(vec_double2 a, vec_double2 b, vec_double2 c) { return spu_msub(a, b, c); }
SM_INLINE vec_double2 sm_dnmsub(vec_double2 a, vec_double2 b, vec_double2 c) { return spu_nmsub(a, b, c); }

/* Masks have all words of a double. */
SM_INLINE vec_double2 sm_dsel(vec_double2 a, vec_double2 b, vec_uint4 mask) {
  return sm_dof(spu_sel(sm_dwords(a), sm_dwords(b), mask));
}
/* The even words in both places. */
SM_INLINE vec_uint4 sm_deven(vec_uint4 words) {
  return spu_shuffle(words, words, SM_BYTES(0, 1, 2, 3, 0, 1, 2, 3, 8, 9, 10, 11, 8, 9, 10, 11));
}
SM_INLINE vec_uint4 sm_dodd(vec_uint4 words) {
  return spu_shuffle(words, words, SM_BYTES(4, 5, 6, 7, 4, 5, 6, 7, 12, 13, 14, 15, 12, 13, 14, 15));
}
SM_INLINE vec_double2 sm_dmasked(vec_double2 x, vec_uint4 mask) { return sm_dof(sm_dwords(x) & mask); }
SM_INLINE vec_double2 sm_dabs(vec_double2 x) { return sm_dof(spu_andc(sm_dwords(x), SM_D_SIGN)); }
SM_INLINE vec_double2 sm_dneg(vec_double2 x) { return sm_dof(sm_dwords(x) ^ SM_D_SIGN); }
SM_INLINE vec_uint4 sm_dsign(vec_double2 x) { return sm_dwords(x) & SM_D_SIGN; }
SM_INLINE vec_double2 sm_dsigned(vec_double2 magnitude, vec_uint4 signs) { return sm_dof(sm_dwords(magnitude) | signs); }
SM_INLINE vec_uint4 sm_dis_negative(vec_double2 x) { return sm_deven((vec_uint4)((vec_int4)sm_dwords(x) >> 31)); }

/* Numbers of 64 bits, without a sign, in the two words. */
SM_INLINE vec_uint4 sm_dgt_words(vec_uint4 a, vec_uint4 b) {
  const vec_uint4 gt = spu_cmpgt(a, b);
  const vec_uint4 eq = spu_cmpeq(a, b);
  return sm_deven(gt) | (sm_deven(eq) & sm_dodd(gt));
}
SM_INLINE vec_uint4 sm_deq_words(vec_uint4 a, vec_uint4 b) {
  const vec_uint4 eq = spu_cmpeq(a, b);
  return sm_deven(eq) & sm_dodd(eq);
}
SM_INLINE vec_uint4 sm_dmagnitude(vec_double2 x) { return spu_andc(sm_dwords(x), SM_D_SIGN); }
/* A denormal operand counts as zero. */
SM_INLINE vec_uint4 sm_dis_zero(vec_double2 x) {
  return sm_deven(spu_cmpeq(sm_dwords(x) & SM_U4(0x7ff00000u), SM_U4(0)));
}
SM_INLINE vec_uint4 sm_dis_special(vec_double2 x) {
  return sm_deven(spu_cmpeq(sm_dwords(x) & SM_U4(0x7ff00000u), SM_U4(0x7ff00000u)));
}
SM_INLINE vec_uint4 sm_dis_infinite(vec_double2 x) { return sm_deq_words(sm_dmagnitude(x), SM_D_HUGE); }
SM_INLINE vec_uint4 sm_dis_nan(vec_double2 x) { return sm_dgt_words(sm_dmagnitude(x), SM_D_HUGE); }
SM_INLINE vec_double2 sm_dkeep_nan(vec_double2 result, vec_double2 x) {
  return sm_dsel(result, sm_dadd(x, x), sm_dis_nan(x));
}
/* Magnitudes without NaNs: |a| > |b|. */
SM_INLINE vec_uint4 sm_dabsgt(vec_double2 a, vec_double2 b) { return sm_dgt_words(sm_dmagnitude(a), sm_dmagnitude(b)); }

/* The order of all numbers as integers without a sign; both zeros, and what counts as such, are equal. */
SM_INLINE vec_uint4 sm_dorder(vec_double2 x) {
  const vec_uint4 words = spu_andc(sm_dwords(x), sm_dis_zero(x));
  return spu_sel(words | SM_D_SIGN, ~words, sm_dis_negative(sm_dof(words)));
}
SM_INLINE vec_uint4 sm_dordered(vec_double2 a, vec_double2 b) { return ~(sm_dis_nan(a) | sm_dis_nan(b)); }
SM_INLINE vec_uint4 sm_dgt(vec_double2 a, vec_double2 b) {
  return sm_dgt_words(sm_dorder(a), sm_dorder(b)) & sm_dordered(a, b);
}
SM_INLINE vec_uint4 sm_deq(vec_double2 a, vec_double2 b) {
  return sm_deq_words(sm_dorder(a), sm_dorder(b)) & sm_dordered(a, b);
}

/* The exponent field, in both words. */
SM_INLINE vec_int4 sm_dexponent(vec_double2 x) {
  return (vec_int4)sm_deven((sm_dwords(x) & SM_U4(0x7ff00000u)) >> 20);
}
/* x = result * 2^exponent with the result from 1 to below 2, for positive normal x. */
SM_INLINE vec_double2 sm_dsplit(vec_double2 x, vec_int4* exponent) {
  *exponent = sm_dexponent(x) - SM_I4(1023);
  return sm_dof((sm_dwords(x) & SM_D_FRACTION) | SM_D_ONE);
}
/* 2^power, for powers of normal numbers; only the even elements of the power count. */
SM_INLINE vec_double2 sm_dpower_of_two(vec_int4 power) {
  return sm_dof((vec_uint4)((power + SM_I4(1023)) << 20) & SM_HIGH_LOW(0xffffffffu, 0u));
}
/* x * 2^power for x near 1: rounded once, to denormal numbers too. */
SM_INLINE vec_double2 sm_dscale(vec_double2 x, vec_int4 power) {
  const vec_int4 limited = sm_ilimit(power, SM_I4(-1200), SM_I4(1200));
  const vec_int4 half = limited >> 1;
  /* A first product that is denormal would count as zero in the second one. */
  const vec_int4 first = (vec_int4)spu_sel((vec_uint4)half, (vec_uint4)(limited + SM_I4(600)), sm_igt(SM_I4(0), limited));
  return sm_dmul(sm_dmul(x, sm_dpower_of_two(first)), sm_dpower_of_two(limited - first));
}

/* Integers in both words of each double, and back: toward zero, for magnitudes below 2^31. */
SM_INLINE vec_double2 sm_ditod(vec_int4 x) {
  const vec_uint4 biased = (vec_uint4)x ^ SM_U4(0x80000000u);
  const vec_uint4 words = spu_sel(SM_U4(0x43300000u), biased, SM_HIGH_LOW(0u, 0xffffffffu));
  return sm_dsub(sm_dof(words), SM_D2(0x1.000008p52));
}
/* To the nearest integer; also the number that it is. */
SM_INLINE vec_double2 sm_dnearest(vec_double2 x, vec_int4* integer) {
  const vec_double2 shifted = sm_dadd(x, SM_D2(0x1.8p52));
  *integer = (vec_int4)sm_dodd(sm_dwords(shifted));
  return sm_dsub(shifted, SM_D2(0x1.8p52));
}

/* Both doubles as floats in the even elements, and back. */
SM_INLINE vec_float4 sm_dtof(vec_double2 x) { return spu_roundtf(x); }
SM_INLINE vec_double2 sm_ftod(vec_float4 x) { return spu_extend(x); }

#endif

#endif
