/* Sines, cosines and tangents, of all angles. */
#ifndef SPU_EMU_SIMDMATH_F4_TRIG_H
#define SPU_EMU_SIMDMATH_F4_TRIG_H

#include "simdmath/private/f4_divide.h"
#include "simdmath/private/two_over_pi.h"

/* An angle = quarter * pi / 2 + high + low, |high| hardly above pi / 4. */
typedef struct sm_fangle {
  vec_uint4 quarter;
  vec_float4 high;
  vec_float4 low;
} sm_fangle;

/* Elements from 2^18 on, one by one. Not inlined: programs that have none only carry it. */
static __attribute__((noinline, unused)) void sm_freduce_large(vec_float4 x, vec_uint4 which, sm_fangle* angle) {
  union {
    vec_uint4 all;
    unsigned int element[4];
  } bits, mask, quarter, first, second;
  vec_int4 exponent;
  int i;
  union {
    vec_int4 all;
    int element[4];
  } power;
  bits.all = (vec_uint4)x;
  mask.all = which;
  quarter.all = angle->quarter;
  first.all = second.all = SM_U4(0);
  power.all = SM_I4(0);
  for (i = 0; i < 4; ++i) {
    sm_quarters q;
    const unsigned int sign = bits.element[i] & 0x80000000u;
    if (mask.element[i] == 0) continue;
    q = sm_to_quarters((bits.element[i] & 0x7fffffu) | 0x800000u, (int)(bits.element[i] >> 23 & 255u) - 150);
    quarter.element[i] = sign != 0 ? 0u - q.quarter : q.quarter;
    first.element[i] = (unsigned int)(q.high >> 40);
    second.element[i] = (unsigned int)(q.high >> 16) & 0xffffffu;
    if (q.negative != (sign != 0)) {
      first.element[i] = 0u - first.element[i];
      second.element[i] = 0u - second.element[i];
    }
    power.element[i] = q.exponent + 64;
  }
  exponent = power.all;
  {
    const vec_float4 a = sm_fscale(sm_itof((vec_int4)first.all), exponent - SM_I4(24));
    const vec_float4 b = sm_fscale(sm_itof((vec_int4)second.all), exponent - SM_I4(48));
    const vec_float4 half_pi = SM_F4(0x1.921fb6p0f);
    const vec_float4 high = sm_fmul(a, half_pi);
    const vec_float4 rest = sm_fmadd(b, half_pi, sm_fmul(a, SM_F4(-0x1.777a5cp-25f)));
    angle->quarter = quarter.all;
    angle->high = sm_fsel(angle->high, high, which);
    angle->low = sm_fsel(angle->low, sm_fsub(rest, sm_fnmsub(a, half_pi, high)), which);
  }
}

SM_INLINE sm_fangle sm_freduce(vec_float4 x) {
  sm_fangle angle;
  const vec_uint4 large = sm_igt(sm_fbits(x), (vec_int4)SM_F4(0x1p18f));
  const vec_float4 moderate = (vec_float4)((vec_uint4)x & ~large);
  const vec_int4 k = sm_fnearest(sm_fmul(moderate, SM_F4(0x1.45f306p-1f)));
  const vec_float4 multiple = sm_itof(k);
  const vec_float4 rest = sm_fnmsub(multiple, SM_F4(0x1.921fb6p0f), moderate);
  const vec_float4 second = SM_F4(-0x1.777a5cp-25f);
  angle.quarter = (vec_uint4)k;
  angle.high = sm_fnmsub(multiple, second, rest);
  angle.low = sm_fnmsub(multiple, SM_F4(-0x1.ee59dap-50f), sm_fnmsub(multiple, second, sm_fsub(rest, angle.high)));
  if (__builtin_expect(sm_any(large & ~sm_fis_special(x)), 0)) {
    sm_freduce_large(x, large & ~sm_fis_special(x), &angle);
  }
  return angle;
}

SM_INLINE vec_float4 sm_fsin_near(sm_fangle a) {
  const vec_float4 square = sm_fmul(a.high, a.high);
  const vec_float4 cubic = sm_fmul(sm_fmul(square, a.high), sm_poly_sin_f4(square));
  return sm_fadd(a.high, sm_fadd(cubic, a.low));
}
SM_INLINE vec_float4 sm_fcos_near(sm_fangle a) {
  const vec_float4 square = sm_fmul(a.high, a.high);
  const vec_float4 tail = sm_fmadd(sm_fmul(square, square), sm_poly_cos_f4(square), sm_fneg(sm_fmul(a.high, a.low)));
  return sm_fadd(sm_fmadd(square, SM_F4(-0.5f), SM_F4(1.0f)), tail);
}

SM_INLINE vec_float4 sm_fof_quarter(vec_float4 even, vec_float4 odd, vec_uint4 quarter) {
  const vec_float4 value = sm_fsel(even, odd, sm_ueq(quarter & SM_U4(1), SM_U4(1)));
  return (vec_float4)((vec_uint4)value ^ ((quarter & SM_U4(2)) << 30));
}

/* An infinite angle of the PPU has no sine. */
SM_INLINE vec_float4 sm_fof_finite_angle(vec_float4 result, vec_float4 x) {
#ifdef __SPU__
  (void)x;
  return result;
#else
  return sm_fsel(result, sm_fsub(x, x), sm_fis_special(x));
#endif
}
/* A small angle and what is as small as its cube. */
SM_INLINE vec_float4 sm_fof_small_angle(vec_float4 result, vec_float4 x) {
  return sm_fsel(result, x, sm_igt(SM_I4(0x39000000), sm_fbits(x)));
}

static inline void _sincosf4(vec_float4 x, vec_float4* sine, vec_float4* cosine) {
  const sm_fangle angle = sm_freduce(x);
  const vec_float4 s = sm_fsin_near(angle);
  const vec_float4 c = sm_fcos_near(angle);
  *sine = sm_fof_finite_angle(sm_fof_small_angle(sm_fof_quarter(s, c, angle.quarter), x), x);
  *cosine = sm_fof_finite_angle(sm_fof_quarter(s, c, angle.quarter + SM_U4(1)), x);
}
static inline vec_float4 _sinf4(vec_float4 x) {
  const sm_fangle angle = sm_freduce(x);
  const vec_float4 result = sm_fof_quarter(sm_fsin_near(angle), sm_fcos_near(angle), angle.quarter);
  return sm_fof_finite_angle(sm_fof_small_angle(result, x), x);
}
static inline vec_float4 _cosf4(vec_float4 x) {
  const sm_fangle angle = sm_freduce(x);
  const vec_uint4 next = angle.quarter + SM_U4(1);
  return sm_fof_finite_angle(sm_fof_quarter(sm_fsin_near(angle), sm_fcos_near(angle), next), x);
}
static inline vec_float4 _tanf4(vec_float4 x) {
  const sm_fangle angle = sm_freduce(x);
  const vec_float4 s = sm_fsin_near(angle);
  const vec_float4 c = sm_fcos_near(angle);
  const vec_uint4 odd = sm_ueq(angle.quarter & SM_U4(1), SM_U4(1));
  const vec_float4 result = sm_fdivide(sm_fsel(s, sm_fneg(c), odd), sm_fsel(c, s, odd));
  return sm_fof_finite_angle(sm_fof_small_angle(result, x), x);
}

#endif
