/* Sines, cosines, tangents of doubles, of all angles, and their inverses. */
#ifndef SPU_EMU_SIMDMATH_D2_TRIG_H
#define SPU_EMU_SIMDMATH_D2_TRIG_H

#include "simdmath/private/d2_divide.h"
#include "simdmath/private/two_over_pi.h"

#ifdef __SPU__

/* An angle = quarter * pi / 2 + high + low, |high| hardly above pi / 4. */
typedef struct sm_dangle {
  vec_uint4 quarter; /* in both words */
  vec_double2 high;
  vec_double2 low;
} sm_dangle;

/* A double of a whole number below 2^53, which is exact. */
SM_INLINE double sm_dof_whole(unsigned long long whole, int negative) {
  return negative ? -(double)(long long)whole : (double)(long long)whole;
}

/* Angles from 2^30 on, one by one. */
static __attribute__((noinline, unused)) void sm_dreduce_large(vec_double2 x, vec_uint4 which,
                                                               sm_dangle* angle) {
  const vec_uint4 words = sm_dwords(x);
  const vec_double2 half_pi = SM_D2(0x1.921fb54442d18p0);
  vec_double2 first = SM_D2(0.0), second = SM_D2(0.0), a, b, high, rest;
  vec_int4 power = SM_I4(0);
  int i;
  for (i = 0; i < 2; ++i) {
    const unsigned int high_word = spu_extract(words, 2 * i);
    const unsigned long long significand =
        ((unsigned long long)((high_word & 0xfffffu) | 0x100000u) << 32) | spu_extract(words, 2 * i + 1);
    const int negative = (int)(high_word >> 31);
    sm_quarters q;
    if (spu_extract(which, 2 * i) == 0) continue;
    q = sm_to_quarters(significand, (int)(high_word >> 20 & 2047u) - 1075);
    first = spu_insert(sm_dof_whole(q.high >> 11, q.negative != negative), first, i);
    second = spu_insert(sm_dof_whole((q.high << 53 | q.low >> 11) >> 11, q.negative != negative), second, i);
    power = spu_insert(q.exponent + 11, power, 2 * i);
    angle->quarter = spu_insert(negative ? 0u - q.quarter : q.quarter, angle->quarter, 2 * i);
  }
  angle->quarter = sm_deven(angle->quarter);
  power = (vec_int4)sm_deven((vec_uint4)power);
  a = sm_dmul(first, sm_dpower_of_two(power));
  b = sm_dmul(second, sm_dpower_of_two(power - SM_I4(53)));
  high = sm_dmul(a, half_pi);
  rest = sm_dmadd(b, half_pi, sm_dmul(a, SM_D2(0x1.1a62633145c07p-54)));
  angle->high = sm_dsel(angle->high, high, which);
  angle->low = sm_dsel(angle->low, sm_dadd(rest, sm_dmsub(a, half_pi, high)), which);
}

SM_INLINE sm_dangle sm_dreduce(vec_double2 x) {
  sm_dangle angle;
  vec_int4 quarter;
  const vec_uint4 large = sm_dabsgt(x, SM_D2(0x1p30)) & ~sm_dis_special(x);
  const vec_double2 moderate = sm_dmasked(x, ~sm_dabsgt(x, SM_D2(0x1p30)));
  const vec_double2 k = sm_dnearest(sm_dmul(moderate, SM_D2(0x1.45f306dc9c883p-1)), &quarter);
  const vec_double2 rest = sm_dnmsub(k, SM_D2(0x1.921fb54442d18p0), moderate);
  /* rest less k * second, each of them as two numbers: they may nearly cancel. */
  const vec_double2 second = SM_D2(0x1.1a62633145c07p-54);
  const vec_double2 product = sm_dmul(k, second);
  const vec_double2 product_low = sm_dmsub(k, second, product);
  const vec_uint4 swapped = sm_dabsgt(product, rest);
  const vec_double2 larger = sm_dsel(rest, sm_dneg(product), swapped);
  const vec_double2 smaller = sm_dsel(sm_dneg(product), rest, swapped);
  angle.quarter = (vec_uint4)quarter;
  angle.high = sm_dadd(larger, smaller);
  angle.low = sm_dsub(sm_dsub(smaller, sm_dsub(angle.high, larger)),
                      sm_dmadd(k, SM_D2(-0x1.f1976b7ed8fbcp-110), product_low));
  if (__builtin_expect(sm_any(large), 0)) sm_dreduce_large(x, large, &angle);
  return angle;
}

SM_INLINE vec_double2 sm_dsin_near(sm_dangle a) {
  const vec_double2 square = sm_dmul(a.high, a.high);
  const vec_double2 cubic = sm_dmul(square, a.high);
  /* The low part's share in the square, too: cos(high) * low. */
  const vec_double2 low = sm_dnmsub(sm_dmul(square, SM_D2(0.5)), a.low, a.low);
  return sm_dadd(a.high, sm_dmadd(cubic, sm_poly_sin_d2(square), low));
}
SM_INLINE vec_double2 sm_dcos_near(sm_dangle a) {
  const vec_double2 square = sm_dmul(a.high, a.high);
  const vec_double2 half = sm_dmul(square, SM_D2(0.5));
  const vec_double2 main = sm_dsub(SM_D2(1.0), half);
  const vec_double2 lost = sm_dsub(sm_dsub(SM_D2(1.0), main), half);
  const vec_double2 tail =
      sm_dmadd(sm_dmul(square, square), sm_poly_cos_d2(square), sm_dneg(sm_dmul(a.high, a.low)));
  return sm_dadd(main, sm_dadd(tail, lost));
}

SM_INLINE vec_uint4 sm_dis_odd_quarter(vec_uint4 quarter) {
  return spu_cmpeq(quarter & SM_U4(1), SM_U4(1));
}
SM_INLINE vec_double2 sm_dof_quarter(vec_double2 even, vec_double2 odd, vec_uint4 quarter) {
  const vec_double2 value = sm_dsel(even, odd, sm_dis_odd_quarter(quarter));
  return sm_dof(sm_dwords(value) ^ (((quarter & SM_U4(2)) << 30) & SM_D_SIGN));
}
SM_INLINE vec_double2 sm_dof_finite_angle(vec_double2 result, vec_double2 x) {
  return sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_special(x));
}
SM_INLINE vec_double2 sm_dof_small_angle(vec_double2 result, vec_double2 x) {
  return sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x));
}

static inline void _sincosd2(vec_double2 x, vec_double2* sine, vec_double2* cosine) {
  const sm_dangle angle = sm_dreduce(x);
  const vec_double2 s = sm_dsin_near(angle);
  const vec_double2 c = sm_dcos_near(angle);
  *sine = sm_dof_finite_angle(sm_dof_small_angle(sm_dof_quarter(s, c, angle.quarter), x), x);
  *cosine = sm_dof_finite_angle(sm_dof_quarter(s, c, angle.quarter + SM_U4(1)), x);
}
static inline vec_double2 _sind2(vec_double2 x) {
  const sm_dangle angle = sm_dreduce(x);
  const vec_double2 result = sm_dof_quarter(sm_dsin_near(angle), sm_dcos_near(angle), angle.quarter);
  return sm_dof_finite_angle(sm_dof_small_angle(result, x), x);
}
static inline vec_double2 _cosd2(vec_double2 x) {
  const sm_dangle angle = sm_dreduce(x);
  const vec_uint4 next = angle.quarter + SM_U4(1);
  return sm_dof_finite_angle(sm_dof_quarter(sm_dsin_near(angle), sm_dcos_near(angle), next), x);
}
static inline vec_double2 _tand2(vec_double2 x) {
  const sm_dangle angle = sm_dreduce(x);
  const vec_double2 s = sm_dsin_near(angle);
  const vec_double2 c = sm_dcos_near(angle);
  const vec_uint4 odd = sm_dis_odd_quarter(angle.quarter);
  const vec_double2 result = sm_ddivide(sm_dsel(s, sm_dneg(c), odd), sm_dsel(c, s, odd));
  return sm_dof_finite_angle(sm_dof_small_angle(result, x), x);
}

/* asin of |x| up to a half, and of s = sqrt((1 - |x|) / 2) beyond, where asin(|x|) = pi / 2 - 2 asin(s). */
typedef struct sm_darc {
  vec_uint4 far;
  vec_double2 value;
} sm_darc;

SM_INLINE sm_darc sm_darc_of(vec_double2 magnitude) {
  sm_darc arc;
  const vec_double2 half = sm_dmul(sm_dsub(SM_D2(1.0), magnitude), SM_D2(0.5));
  const vec_uint4 positive = spu_andc(~sm_dis_zero(half), sm_dis_negative(half));
  vec_double2 near, square;
  arc.far = sm_dabsgt(magnitude, SM_D2(0.5));
  near = sm_dmasked(sm_droot(sm_dsel(SM_D2(0.25), half, positive & arc.far)), positive);
  near = sm_dsel(magnitude, near, arc.far);
  square = sm_dsel(sm_dmul(magnitude, magnitude), half, arc.far);
  arc.value = sm_dmadd(sm_dmul(near, square), sm_poly_asin_d2(square), near);
  return arc;
}
SM_INLINE vec_double2 sm_dof_cosine(vec_double2 result, vec_double2 x) {
  return sm_dkeep_nan(sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dabsgt(x, SM_D2(1.0))), x);
}

static inline vec_double2 _asind2(vec_double2 x) {
  const sm_darc arc = sm_darc_of(sm_dabs(x));
  const vec_double2 from_quarter =
      sm_dadd(SM_D2(0x1.921fb54442d18p0), sm_dmadd(arc.value, SM_D2(-2.0), SM_D2(0x1.1a62633145c07p-54)));
  return sm_dof_cosine(sm_dsigned(sm_dsel(arc.value, from_quarter, arc.far), sm_dsign(x)), x);
}
static inline vec_double2 _acosd2(vec_double2 x) {
  const sm_darc arc = sm_darc_of(sm_dabs(x));
  const vec_double2 signed_value = sm_dsigned(arc.value, sm_dsign(x));
  const vec_double2 near =
      sm_dsub(SM_D2(0x1.921fb54442d18p0), sm_dsub(signed_value, SM_D2(0x1.1a62633145c07p-54)));
  const vec_double2 twice = sm_dadd(arc.value, arc.value);
  const vec_double2 from_half =
      sm_dsub(SM_D2(0x1.921fb54442d18p1), sm_dsub(twice, SM_D2(0x1.1a62633145c07p-53)));
  return sm_dof_cosine(sm_dsel(near, sm_dsel(twice, from_half, sm_dis_negative(x)), arc.far), x);
}

/* The angle of (x, y), both positive and not both zero, neither near the ends of the range. */
SM_INLINE vec_double2 sm_dangle_of(vec_double2 y, vec_double2 x, vec_uint4 x_is_negative) {
  const vec_uint4 steep = sm_dabsgt(y, x);
  const vec_double2 larger = sm_dsel(x, y, steep);
  const vec_double2 smaller = sm_dsel(y, x, steep);
  const vec_uint4 middle = sm_dabsgt(smaller, sm_dmul(larger, SM_D2(0x1.a827999fcef32p-2)));
  const vec_double2 t = sm_ddivide(sm_dsel(smaller, sm_dsub(smaller, larger), middle),
                                   sm_dsel(larger, sm_dadd(smaller, larger), middle));
  const vec_double2 square = sm_dmul(t, t);
  const vec_double2 tail = sm_dmul(sm_dmul(t, square), sm_poly_atan_d2(square));
  const vec_uint4 turned = (steep ^ x_is_negative) & SM_D_SIGN;
  vec_int4 eighths = (vec_int4)(middle & SM_U4(1));
  vec_double2 base, low;
  eighths = (vec_int4)spu_sel((vec_uint4)eighths, (vec_uint4)(SM_I4(2) - eighths), steep);
  eighths = (vec_int4)spu_sel((vec_uint4)eighths, (vec_uint4)(SM_I4(4) - eighths), x_is_negative);
  base = sm_ditod(eighths);
  low = sm_dmadd(base, SM_D2(0x1.1a62633145c07p-55), sm_dof(sm_dwords(tail) ^ turned));
  return sm_dmadd(base, SM_D2(0x1.921fb54442d18p-1), sm_dadd(sm_dof(sm_dwords(t) ^ turned), low));
}

static inline vec_double2 _atand2(vec_double2 x) {
  const vec_double2 limited = sm_dsel(sm_dabs(x), SM_D2(0x1p80), sm_dabsgt(x, SM_D2(0x1p80)));
  const vec_double2 result = sm_dsigned(sm_dangle_of(limited, SM_D2(1.0), SM_U4(0)), sm_dsign(x));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-28), x)), x);
}

static inline vec_double2 _atan2d2(vec_double2 y, vec_double2 x) {
  vec_int4 exponent_y, exponent_x, distance;
  const vec_uint4 infinite_y = sm_dis_special(y);
  const vec_uint4 infinite_x = sm_dis_special(x);
  const vec_double2 part_y = sm_dsplit(sm_dsel(y, SM_D2(1.0), infinite_y), &exponent_y);
  const vec_double2 part_x = sm_dsplit(sm_dsel(x, SM_D2(1.0), infinite_x), &exponent_x);
  const vec_uint4 negative_x = sm_dis_negative(x);
  const vec_uint4 flat = sm_dis_zero(y) | spu_andc(infinite_x, infinite_y);
  const vec_uint4 steep = spu_andc(sm_dis_zero(x), sm_dis_zero(y)) | spu_andc(infinite_y, infinite_x);
  vec_double2 scaled_y, result;
  distance = (vec_int4)spu_andc((vec_uint4)(exponent_y - exponent_x), infinite_x & infinite_y);
  scaled_y = sm_dscale(part_y, sm_ilimit(distance, SM_I4(-90), SM_I4(90)));
  scaled_y = sm_dsel(sm_dmasked(scaled_y, ~flat), SM_D2(0x1p90), steep);
  result = sm_dangle_of(scaled_y, part_x, negative_x);
  /* What is so flat that its angle is the quotient, which may be small. */
  {
    const vec_double2 quotient = sm_dscale(sm_ddivide(part_y, part_x), distance);
    const vec_uint4 is_quotient = spu_andc(sm_igt(SM_I4(-32), distance), negative_x | flat | steep);
    result = sm_dsel(result, quotient, is_quotient);
  }
  return sm_dkeep_nan(sm_dkeep_nan(sm_dsigned(result, sm_dsign(y)), x), y);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
