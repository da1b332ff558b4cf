/* The inverses of sine, cosine and tangent. */
#ifndef SPU_EMU_SIMDMATH_F4_ARC_H
#define SPU_EMU_SIMDMATH_F4_ARC_H

#include "simdmath/private/f4_divide.h"

SM_INLINE vec_float4 sm_fodd(vec_float4 x, vec_float4 square, vec_float4 p) {
  return sm_fmadd(sm_fmul(x, square), p, x);
}

/* asin(|x|) = offset - 2 * asin(s) from a half on, with s = sqrt((1 - |x|) / 2). */
typedef struct sm_farc {
  vec_uint4 far;
  vec_float4 value;
} sm_farc;

SM_INLINE sm_farc sm_farc_of(vec_float4 magnitude) {
  sm_farc arc;
  vec_float4 half, near, square;
  arc.far = sm_igt((vec_int4)magnitude, SM_I4(0x3f000000));
  half = sm_fmul(sm_fsub(SM_F4(1.0f), magnitude), SM_F4(0.5f));
  near = sm_froot(sm_fsel(SM_F4(0.25f), half, arc.far & sm_fgt(half, SM_F4(0.0f))));
  near = (vec_float4)((vec_uint4)near & sm_fgt(half, SM_F4(0.0f)));
  near = sm_fsel(magnitude, near, arc.far);
  square = sm_fsel(sm_fmul(magnitude, magnitude), half, arc.far);
  arc.value = sm_fodd(near, square, sm_poly_asin_f4(square));
  return arc;
}

SM_INLINE vec_float4 sm_fof_cosine(vec_float4 result, vec_float4 x) {
  return sm_fkeep_nan(sm_fsel(result, (vec_float4)SM_F_NOTHING, sm_igt(sm_fbits(x), SM_I4(0x3f800000))), x);
}

static inline vec_float4 _asinf4(vec_float4 x) {
  const vec_float4 magnitude = sm_fabs(x);
  const sm_farc arc = sm_farc_of(magnitude);
  const vec_float4 from_quarter =
      sm_fadd(SM_F4(0x1.921fb6p0f), sm_fmadd(arc.value, SM_F4(-2.0f), SM_F4(-0x1.777a5cp-25f)));
  const vec_float4 result = sm_fsel(arc.value, from_quarter, arc.far);
  return sm_fof_cosine(sm_fsigned(result, sm_fsign(x)), x);
}

static inline vec_float4 _acosf4(vec_float4 x) {
  const sm_farc arc = sm_farc_of(sm_fabs(x));
  const vec_uint4 negative = (vec_uint4)((vec_int4)x >> 31);
  const vec_float4 near =
      sm_fsub(SM_F4(0x1.921fb6p0f), sm_fadd(sm_fsigned(arc.value, sm_fsign(x)), SM_F4(0x1.777a5cp-25f)));
  const vec_float4 twice = sm_fadd(arc.value, arc.value);
  const vec_float4 from_half = sm_fsub(SM_F4(0x1.921fb6p1f), sm_fadd(twice, SM_F4(0x1.777a5cp-24f)));
  return sm_fof_cosine(sm_fsel(near, sm_fsel(twice, from_half, negative), arc.far), x);
}

/* The angle of (x, y), both positive and not both zero, neither near the ends of the range. */
SM_INLINE vec_float4 sm_fangle_of(vec_float4 y, vec_float4 x, vec_uint4 x_is_negative) {
  const vec_uint4 steep = sm_fgt(y, x);
  const vec_float4 larger = sm_fsel(x, y, steep);
  const vec_float4 smaller = sm_fsel(y, x, steep);
  const vec_uint4 middle = sm_fgt(smaller, sm_fmul(larger, SM_F4(0x1.a8279ap-2f)));
  const vec_float4 t = sm_fdivide(sm_fsel(smaller, sm_fsub(smaller, larger), middle),
                                  sm_fsel(larger, sm_fadd(smaller, larger), middle));
  const vec_float4 square = sm_fmul(t, t);
  const vec_float4 tail = sm_fmul(sm_fmul(t, square), sm_poly_atan_f4(square));
  /* The angle is base + turn * (t + tail), base a multiple of an eighth of a turn. */
  vec_int4 eighths = (vec_int4)(middle & SM_U4(1));
  const vec_uint4 mirrored = steep ^ x_is_negative;
  vec_float4 base, high, low;
  eighths = (vec_int4)sm_usel((vec_uint4)eighths, (vec_uint4)(SM_I4(2) - eighths), steep);
  eighths = (vec_int4)sm_usel((vec_uint4)eighths, (vec_uint4)(SM_I4(4) - eighths), x_is_negative);
  base = sm_itof(eighths);
  high = (vec_float4)((vec_uint4)t ^ (mirrored & SM_F_SIGN));
  low = sm_fmadd(base, SM_F4(-0x1.777a5cp-26f), (vec_float4)((vec_uint4)tail ^ (mirrored & SM_F_SIGN)));
  return sm_fmadd(base, SM_F4(0x1.921fb6p-1f), sm_fadd(high, low));
}

static inline vec_float4 _atanf4(vec_float4 x) {
  const vec_float4 limited = sm_fsel(sm_fabs(x), SM_F4(0x1p40f), sm_igt(sm_fbits(x), (vec_int4)SM_F4(0x1p40f)));
  const vec_float4 result = sm_fangle_of(limited, SM_F4(1.0f), SM_U4(0));
  const vec_float4 known = sm_fsel(sm_fsigned(result, sm_fsign(x)), x, sm_igt(SM_I4(0x39000000), sm_fbits(x)));
  return sm_fkeep_nan(known, x);
}

/* The signs of zeros count. */
static inline vec_float4 _atan2f4(vec_float4 y, vec_float4 x) {
  vec_int4 exponent_y, exponent_x;
  const vec_uint4 infinite_y = sm_fis_special(y);
  const vec_uint4 infinite_x = sm_fis_special(x);
  const vec_float4 part_y = sm_fsplit(sm_fsel(y, SM_F4(1.0f), infinite_y), &exponent_y);
  const vec_float4 part_x = sm_fsplit(sm_fsel(x, SM_F4(1.0f), infinite_x), &exponent_x);
  vec_int4 distance = exponent_y - exponent_x;
  const vec_uint4 negative_x = (vec_uint4)((vec_int4)x >> 31);
  const vec_uint4 flat = sm_fis_zero(y) | (infinite_x & ~infinite_y);
  const vec_uint4 steep = (sm_fis_zero(x) & ~sm_fis_zero(y)) | (infinite_y & ~infinite_x);
  vec_float4 scaled_y, result;
  distance = (vec_int4)((vec_uint4)distance & ~(infinite_x & infinite_y));
  scaled_y = sm_fscale(part_y, sm_ilimit(distance, SM_I4(-60), SM_I4(60)));
  scaled_y = sm_fsel((vec_float4)((vec_uint4)scaled_y & ~flat), SM_F4(0x1p60f), steep);
  result = sm_fangle_of(scaled_y, part_x, negative_x);
  /* What is so flat that its angle is the quotient, which may be small. */
  {
    const vec_float4 quotient = sm_fscale(sm_fdivide(part_y, part_x), distance);
    const vec_uint4 is_quotient = sm_igt(SM_I4(-20), distance) & ~(negative_x | flat | steep);
    result = sm_fsel(result, quotient, is_quotient);
  }
  return sm_fkeep_nan(sm_fkeep_nan(sm_fsigned(result, sm_fsign(y)), x), y);
}

#endif
