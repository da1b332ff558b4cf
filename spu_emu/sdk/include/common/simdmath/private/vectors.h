/* What the SIMD math library asks of the SPU's and of the PPU's vector unit: float4 and int4.
 *
 * Integers are worked on with the compiler's own operators. A mask has all bits of an element set or none. */
#ifndef SPU_EMU_SIMDMATH_VECTORS_H
#define SPU_EMU_SIMDMATH_VECTORS_H

#include "simdmath/private/types.h"

#define SM_F4(c) ((vec_float4){(c), (c), (c), (c)})
#define SM_U4(c) ((vec_uint4){(c), (c), (c), (c)})
#define SM_I4(c) ((vec_int4){(c), (c), (c), (c)})

#define SM_F_SIGN SM_U4(0x80000000u)
#define SM_F_MAGNITUDE SM_U4(0x7fffffffu)
#define SM_F_EXPONENT SM_U4(0x7f800000u)
#define SM_F_FRACTION SM_U4(0x007fffffu)
#define SM_F_ONE SM_U4(0x3f800000u)

#ifdef __SPU__

/* The largest number stands for what is too large, and for what has no value: there is no infinity and no NaN. */
#define SM_F_HUGE SM_U4(0x7fffffffu)
#define SM_F_NOTHING SM_U4(0x7fffffffu)

SM_INLINE vec_float4 sm_fadd(vec_float4 a, vec_float4 b) { return spu_add(a, b); }
SM_INLINE vec_float4 sm_fsub(vec_float4 a, vec_float4 b) { return spu_sub(a, b); }
SM_INLINE vec_float4 sm_fmul(vec_float4 a, vec_float4 b) { return spu_mul(a, b); }
/* a * b + c, c - a * b: rounded once. */
SM_INLINE vec_float4 sm_fmadd(vec_float4 a, vec_float4 b, vec_float4 c) { return spu_madd(a, b, c); }
SM_INLINE vec_float4 sm_fnmsub(vec_float4 a, vec_float4 b, vec_float4 c) { return spu_nmsub(a, b, c); }
/* About 12 bits of 1 / a and 1 / sqrt(a). */
SM_INLINE vec_float4 sm_frecip_guess(vec_float4 a) { return spu_re(a); }
SM_INLINE vec_float4 sm_frsqrt_guess(vec_float4 a) { return spu_rsqrte(a); }
SM_INLINE vec_uint4 sm_fgt(vec_float4 a, vec_float4 b) { return spu_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_feq(vec_float4 a, vec_float4 b) { return spu_cmpeq(a, b); }
/* b where the mask is set, a elsewhere. */
SM_INLINE vec_float4 sm_fsel(vec_float4 a, vec_float4 b, vec_uint4 mask) { return spu_sel(a, b, mask); }
SM_INLINE vec_uint4 sm_usel(vec_uint4 a, vec_uint4 b, vec_uint4 mask) { return spu_sel(a, b, mask); }
SM_INLINE vec_uint4 sm_igt(vec_int4 a, vec_int4 b) { return spu_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_ugt(vec_uint4 a, vec_uint4 b) { return spu_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_ueq(vec_uint4 a, vec_uint4 b) { return spu_cmpeq(a, b); }
/* Toward zero, limited to what an int holds. */
SM_INLINE vec_int4 sm_ftoi(vec_float4 a) { return spu_convts(a, 0); }
SM_INLINE vec_float4 sm_itof(vec_int4 a) { return spu_convtf(a, 0); }
SM_INLINE int sm_any(vec_uint4 mask) { return spu_extract(spu_gather(mask), 0) != 0; }

#else

#define SM_F_HUGE SM_U4(0x7f800000u)
#define SM_F_NOTHING SM_U4(0x7fc00000u)

SM_INLINE vec_float4 sm_fadd(vec_float4 a, vec_float4 b) { return vec_add(a, b); }
SM_INLINE vec_float4 sm_fsub(vec_float4 a, vec_float4 b) { return vec_sub(a, b); }
SM_INLINE vec_float4 sm_fmul(vec_float4 a, vec_float4 b) { return vec_madd(a, b, SM_F4(-0.0f)); }
SM_INLINE vec_float4 sm_fmadd(vec_float4 a, vec_float4 b, vec_float4 c) { return vec_madd(a, b, c); }
SM_INLINE vec_float4 sm_fnmsub(vec_float4 a, vec_float4 b, vec_float4 c) { return vec_nmsub(a, b, c); }
SM_INLINE vec_float4 sm_frecip_guess(vec_float4 a) { return vec_re(a); }
SM_INLINE vec_float4 sm_frsqrt_guess(vec_float4 a) { return vec_rsqrte(a); }
SM_INLINE vec_uint4 sm_fgt(vec_float4 a, vec_float4 b) { return (vec_uint4)vec_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_feq(vec_float4 a, vec_float4 b) { return (vec_uint4)vec_cmpeq(a, b); }
SM_INLINE vec_float4 sm_fsel(vec_float4 a, vec_float4 b, vec_uint4 mask) { return vec_sel(a, b, mask); }
SM_INLINE vec_uint4 sm_usel(vec_uint4 a, vec_uint4 b, vec_uint4 mask) { return vec_sel(a, b, mask); }
SM_INLINE vec_uint4 sm_igt(vec_int4 a, vec_int4 b) { return (vec_uint4)vec_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_ugt(vec_uint4 a, vec_uint4 b) { return (vec_uint4)vec_cmpgt(a, b); }
SM_INLINE vec_uint4 sm_ueq(vec_uint4 a, vec_uint4 b) { return (vec_uint4)vec_cmpeq(a, b); }
SM_INLINE vec_int4 sm_ftoi(vec_float4 a) { return vec_cts(a, 0); }
SM_INLINE vec_float4 sm_itof(vec_int4 a) { return vec_ctf(a, 0); }
SM_INLINE int sm_any(vec_uint4 mask) { return vec_any_ne(mask, SM_U4(0)); }

#endif

SM_INLINE vec_float4 sm_fabs(vec_float4 x) { return (vec_float4)((vec_uint4)x & SM_F_MAGNITUDE); }
SM_INLINE vec_float4 sm_fneg(vec_float4 x) { return (vec_float4)((vec_uint4)x ^ SM_F_SIGN); }
SM_INLINE vec_uint4 sm_fsign(vec_float4 x) { return (vec_uint4)x & SM_F_SIGN; }
/* The magnitude with the signs. */
SM_INLINE vec_float4 sm_fsigned(vec_float4 magnitude, vec_uint4 signs) {
  return (vec_float4)((vec_uint4)magnitude | signs);
}
SM_INLINE vec_int4 sm_fexponent(vec_float4 x) { return (vec_int4)(((vec_uint4)x & SM_F_EXPONENT) >> 23); }
/* Compares of magnitudes as integers, which order all of them. */
SM_INLINE vec_int4 sm_fbits(vec_float4 x) { return (vec_int4)((vec_uint4)x & SM_F_MAGNITUDE); }
/* Every number with exponent 0 is zero: to the SPU, and to AltiVec as Linux sets it. */
SM_INLINE vec_uint4 sm_fis_zero(vec_float4 x) { return sm_ueq((vec_uint4)x & SM_F_EXPONENT, SM_U4(0)); }

/* All ones for a NaN, and for an infinity or NaN; the SPU has neither. */
SM_INLINE vec_uint4 sm_fis_nan(vec_float4 x) {
#ifdef __SPU__
  return SM_U4(0) & (vec_uint4)x;
#else
  return sm_igt(sm_fbits(x), SM_I4(0x7f800000));
#endif
}
SM_INLINE vec_uint4 sm_fis_special(vec_float4 x) {
#ifdef __SPU__
  return SM_U4(0) & (vec_uint4)x;
#else
  return sm_igt(sm_fbits(x), SM_I4(0x7f7fffff));
#endif
}
/* The result, but a NaN where x is one. */
SM_INLINE vec_float4 sm_fkeep_nan(vec_float4 result, vec_float4 x) {
#ifdef __SPU__
  (void)x;
  return result;
#else
  return sm_fsel(result, sm_fadd(x, x), sm_fis_nan(x));
#endif
}

/* x = m * 2^exponent with m from 1 to below 2, for positive normal x. */
SM_INLINE vec_float4 sm_fsplit(vec_float4 x, vec_int4* exponent) {
  *exponent = sm_fexponent(x) - SM_I4(127);
  return (vec_float4)(((vec_uint4)x & SM_F_FRACTION) | SM_F_ONE);
}

SM_INLINE vec_int4 sm_ilimit(vec_int4 x, vec_int4 least, vec_int4 most) {
  const vec_uint4 above = sm_usel((vec_uint4)x, (vec_uint4)least, sm_igt(least, x));
  return (vec_int4)sm_usel(above, (vec_uint4)most, sm_igt(x, most));
}

/* x * 2^power, for x that is zero or has an exponent near that of 1. */
SM_INLINE vec_float4 sm_fscale(vec_float4 x, vec_int4 power) {
  const vec_int4 limited = sm_ilimit(power, SM_I4(-480), SM_I4(480));
#ifdef __SPU__
  const vec_int4 exponent = sm_fexponent(x) + limited;
  const vec_uint4 shifted = (vec_uint4)x + ((vec_uint4)limited << 23);
  const vec_uint4 large = sm_usel(shifted, sm_fsign(x) | SM_F_HUGE, sm_igt(exponent, SM_I4(255)));
  return (vec_float4)(large & ~(sm_igt(SM_I4(1), exponent) | sm_fis_zero(x)));
#else
  const vec_int4 quarter = limited >> 2;
  const vec_float4 factor = (vec_float4)((vec_uint4)(quarter + SM_I4(127)) << 23);
  const vec_float4 rest = (vec_float4)((vec_uint4)(limited - quarter - quarter - quarter + SM_I4(127)) << 23);
  return sm_fmul(sm_fmul(sm_fmul(sm_fmul(x, rest), factor), factor), factor);
#endif
}

/* To the nearest integer, halves away from zero, for magnitudes below 2^22. */
SM_INLINE vec_int4 sm_fnearest(vec_float4 x) {
  return sm_ftoi(sm_fadd(x, sm_fsigned(SM_F4(0.5f), sm_fsign(x))));
}

#endif
