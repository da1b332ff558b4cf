/* Exponentials, logarithms and powers of doubles. */
#ifndef SPU_EMU_SIMDMATH_D2_EXP_LOG_H
#define SPU_EMU_SIMDMATH_D2_EXP_LOG_H

#include "simdmath/private/d2_divide.h"

#ifdef __SPU__

SM_INLINE vec_double2 sm_dlimit(vec_double2 x, vec_double2 most) {
  return sm_dsel(x, sm_dsigned(most, sm_dsign(x)), sm_dabsgt(x, most));
}

/* e^r - 1 for |r| up to log(2) / 2 and a little. */
SM_INLINE vec_double2 sm_dexp_near(vec_double2 r, vec_double2 low) {
  return sm_dadd(r, sm_dmadd(sm_dmul(r, r), sm_poly_exp_d2(r), low));
}
/* e^x = (result + 1) * 2^power, for |x| up to 2000. */
SM_INLINE vec_double2 sm_dexp_parts(vec_double2 x, vec_int4* power) {
  const vec_double2 k = sm_dnearest(sm_dmul(x, SM_D2(0x1.71547652b82fep0)), power);
  const vec_double2 high = sm_dnmsub(k, SM_D2(0x1.62e42fefa3800p-1), x);
  const vec_double2 low = SM_D2(0x1.ef35793c76730p-45);
  const vec_double2 r = sm_dnmsub(k, low, high);
  return sm_dexp_near(r, sm_dnmsub(k, low, sm_dsub(high, r)));
}

static inline vec_double2 _expd2(vec_double2 x) {
  vec_int4 power;
  const vec_double2 minus_one = sm_dexp_parts(sm_dlimit(x, SM_D2(1000.0)), &power);
  return sm_dkeep_nan(sm_dscale(sm_dadd(minus_one, SM_D2(1.0)), power), x);
}

/* 2^(x + low) = result * 2^power. */
SM_INLINE vec_double2 sm_dexp2_parts(vec_double2 x, vec_double2 low, vec_int4* power) {
  const vec_double2 k = sm_dnearest(x, power);
  const vec_double2 high = sm_dsub(x, k);
  const vec_double2 r = sm_dadd(high, low);
  const vec_double2 rest = sm_dadd(low, sm_dsub(high, r));
  const vec_double2 ln2 = SM_D2(0x1.62e42fefa39efp-1);
  const vec_double2 y = sm_dmul(r, ln2);
  const vec_double2 y_low =
      sm_dmadd(rest, ln2, sm_dmadd(r, SM_D2(0x1.abc9e3b39803fp-56), sm_dmsub(r, ln2, y)));
  return sm_dadd(sm_dexp_near(y, y_low), SM_D2(1.0));
}
SM_INLINE vec_double2 sm_dexp2_of_pair(vec_double2 x, vec_double2 low) {
  vec_int4 power;
  const vec_double2 result = sm_dexp2_parts(x, low, &power);
  return sm_dscale(result, power);
}
static inline vec_double2 _exp2d2(vec_double2 x) {
  return sm_dkeep_nan(sm_dexp2_of_pair(sm_dlimit(x, SM_D2(1500.0)), SM_D2(0.0)), x);
}

static inline vec_double2 _expm1d2(vec_double2 x) {
  vec_int4 power;
  const vec_double2 limited =
      sm_dsel(sm_dlimit(x, SM_D2(1000.0)), SM_D2(-50.0), sm_dis_negative(x) & sm_dabsgt(x, SM_D2(50.0)));
  const vec_double2 minus_one = sm_dexp_parts(limited, &power);
  const vec_double2 one_less =
      sm_dsub(SM_D2(1.0), sm_dpower_of_two(SM_I4(0) - sm_ilimit(power, SM_I4(-80), SM_I4(80))));
  const vec_double2 scaled = sm_dscale(sm_dadd(one_less, minus_one), power);
  const vec_double2 result = sm_dsel(scaled, minus_one, spu_cmpeq(power, SM_I4(0)));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-54), x)), x);
}

/* x = (1 + result) * 2^exponent with the result from sqrt(1/2) - 1 to sqrt(2) - 1, for positive x. */
SM_INLINE vec_double2 sm_dlog_parts(vec_double2 x, vec_int4* exponent) {
  vec_int4 whole;
  const vec_double2 part = sm_dsplit(x, &whole);
  const vec_uint4 above = sm_deven(sm_igt((vec_int4)sm_dwords(part), SM_I4(0x3ff6a09e)));
  *exponent = whole - (vec_int4)above;
  return sm_dsub(sm_dof(sm_dwords(part) - (above & SM_HIGH_LOW(1u << 20, 0u))), SM_D2(1.0));
}

SM_INLINE vec_double2 sm_dlog_of_specials(vec_double2 result, vec_double2 x) {
  vec_double2 known = sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_negative(x));
  known = sm_dsel(known, sm_dof(SM_D_HUGE | SM_D_SIGN), sm_dis_zero(x));
  return sm_dkeep_nan(sm_dsel(known, x, sm_deq_words(sm_dwords(x), SM_D_HUGE)), x);
}

/* log(1 + f + rest / (1 + f)) + exponent * log(2). */
SM_INLINE vec_double2 sm_dlog_sum(vec_double2 f, vec_double2 rest, vec_int4 exponent) {
  const vec_double2 e = sm_ditod(exponent);
  const vec_double2 s = sm_ddivide(f, sm_dadd(f, SM_D2(2.0)));
  const vec_double2 z = sm_dmul(s, s);
  const vec_double2 half_square = sm_dmul(sm_dmul(f, f), SM_D2(0.5));
  const vec_double2 series = sm_dmul(sm_dadd(z, z), sm_poly_atanh_d2(z));
  const vec_double2 low = sm_dmadd(e, SM_D2(0x1.ef35793c76730p-45), rest);
  const vec_double2 tail = sm_dsub(half_square, sm_dmadd(s, sm_dadd(half_square, series), low));
  return sm_dmadd(e, SM_D2(0x1.62e42fefa3800p-1), sm_dsub(f, tail));
}

static inline vec_double2 _logd2(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 f = sm_dlog_parts(x, &exponent);
  return sm_dlog_of_specials(sm_dlog_sum(f, SM_D2(0.0), exponent), x);
}

/* log(1 + x + low), low being small beside x, for x from -1 to 2^100 without what is special. */
SM_INLINE vec_double2 sm_dlog1p(vec_double2 x, vec_double2 low) {
  vec_int4 exponent;
  const vec_double2 one = SM_D2(1.0);
  const vec_double2 sum = sm_dadd(x, one);
  const vec_double2 lost = sm_dsel(sm_dsub(x, sm_dsub(sum, one)), sm_dsub(one, sm_dsub(sum, x)),
                                   spu_andc(sm_dabsgt(x, one), sm_dis_negative(x)));
  const vec_double2 parts = sm_dlog_parts(sum, &exponent);
  const vec_uint4 direct = sm_dabsgt(SM_D2(0.29), x);
  const vec_double2 f = sm_dsel(parts, x, direct);
  const vec_double2 rest = sm_dmul(sm_dadd(sm_dmasked(lost, ~direct), low), sm_dreciprocal(sum));
  return sm_dlog_sum(f, rest, (vec_int4)spu_andc((vec_uint4)exponent, direct));
}

static inline vec_double2 _log1pd2(vec_double2 x) {
  const vec_uint4 large = sm_dabsgt(x, SM_D2(0x1p100));
  vec_double2 result = sm_dsel(sm_dlog1p(sm_dmasked(x, ~large), SM_D2(0.0)), _logd2(x), large);
  result = sm_dsel(result, sm_dof(SM_D_NOTHING), sm_dis_negative(x) & sm_dabsgt(x, SM_D2(1.0)));
  result = sm_dsel(result, sm_dof(SM_D_HUGE | SM_D_SIGN), sm_deq_words(sm_dwords(x), SM_D_ONE | SM_D_SIGN));
  return sm_dkeep_nan(sm_dsel(result, x, sm_dabsgt(SM_D2(0x1p-54), x)), x);
}

/* A number as the sum of two. */
typedef struct sm_dpair {
  vec_double2 high;
  vec_double2 low;
} sm_dpair;

SM_INLINE sm_dpair sm_dquick_sum(vec_double2 larger, vec_double2 smaller, vec_double2 low) {
  sm_dpair sum;
  sum.high = sm_dadd(larger, smaller);
  sum.low = sm_dadd(sm_dadd(sm_dsub(larger, sum.high), smaller), low);
  return sum;
}
SM_INLINE sm_dpair sm_dproduct(sm_dpair a, sm_dpair b) {
  sm_dpair product;
  product.high = sm_dmul(a.high, b.high);
  product.low = sm_dmadd(a.high, b.low, sm_dmadd(a.low, b.high, sm_dmsub(a.high, b.high, product.high)));
  return product;
}
SM_INLINE sm_dpair sm_dpair_of(double high, double low) {
  sm_dpair pair;
  pair.high = SM_D2(high);
  pair.low = SM_D2(low);
  return pair;
}

/* log2(x) of positive x with some 64 bits: 2 / log(2) * (s + s^3 (1/3 + s^2 p)) with s = f / (2 + f). */
SM_INLINE sm_dpair sm_dlog2_pair(vec_double2 x) {
  vec_int4 exponent;
  const vec_double2 f = sm_dlog_parts(x, &exponent);
  const vec_double2 e = sm_ditod(exponent);
  const vec_double2 two = SM_D2(2.0);
  const vec_double2 divisor = sm_dadd(two, f);
  const vec_double2 divisor_low = sm_dsub(f, sm_dsub(divisor, two));
  const vec_double2 recip = sm_dreciprocal(divisor);
  const sm_dpair third = sm_dpair_of(0x1.5555555555555p-2, 0x1.5555555555555p-56);
  sm_dpair s, square, factor, cubic, log2;
  vec_double2 series;
  s.high = sm_ddivide(f, divisor);
  s.low = sm_dmul(sm_dnmsub(s.high, divisor_low, sm_dnmsub(s.high, divisor, f)), recip);
  square = sm_dproduct(s, s);
  series = sm_dmul(square.high, sm_poly_atanh5_d2(square.high));
  factor = sm_dquick_sum(third.high, series, third.low);
  cubic = sm_dproduct(s, sm_dproduct(square, factor));
  log2 = sm_dquick_sum(s.high, cubic.high, sm_dadd(s.low, cubic.low));
  log2 = sm_dproduct(log2, sm_dpair_of(0x1.71547652b82fep+1, 0x1.777d0ffda0d24p-55));
  return sm_dquick_sum(e, log2.high, log2.low);
}

static inline vec_double2 _log2d2(vec_double2 x) {
  const sm_dpair log2 = sm_dlog2_pair(x);
  return sm_dlog_of_specials(sm_dadd(log2.high, log2.low), x);
}
static inline vec_double2 _log10d2(vec_double2 x) {
  const sm_dpair log10 =
      sm_dproduct(sm_dlog2_pair(x), sm_dpair_of(0x1.34413509f79ffp-2, -0x1.9dc1da994fd21p-59));
  return sm_dlog_of_specials(sm_dadd(log10.high, log10.low), x);
}

/* |x|^y for what is neither zero nor special. */
SM_INLINE vec_double2 sm_dpower(vec_double2 x, vec_double2 y) {
  const sm_dpair log2 = sm_dlog2_pair(sm_dabs(x));
  const vec_double2 exponent = sm_dlimit(y, SM_D2(0x1p70));
  const vec_double2 product = sm_dmul(exponent, log2.high);
  const vec_uint4 far = sm_dabsgt(product, SM_D2(2000.0));
  const vec_double2 low = sm_dmadd(exponent, log2.low, sm_dmsub(exponent, log2.high, product));
  return sm_dexp2_of_pair(sm_dlimit(product, SM_D2(2000.0)), sm_dmasked(low, ~far));
}

/* Whole, and odd. */
SM_INLINE vec_uint4 sm_dis_odd(vec_double2 y) {
  const vec_uint4 half_has_fraction = sm_dhas_fraction(sm_dmul(y, SM_D2(0.5)));
  return spu_andc(half_has_fraction, sm_dhas_fraction(y));
}

static inline vec_double2 _powd2(vec_double2 x, vec_double2 y) {
  const vec_uint4 whole = ~sm_dhas_fraction(y);
  const vec_uint4 odd = sm_dis_odd(y);
  const vec_uint4 falls = sm_dis_negative(y);
  const vec_uint4 zero_or_infinite = sm_dis_zero(x) | sm_dis_infinite(x);
  const vec_uint4 becomes_infinite = sm_dis_infinite(x) ^ falls;
  vec_double2 result = sm_dpower(x, y);
  result = sm_dsel(result, sm_dof(SM_D_HUGE & becomes_infinite), zero_or_infinite);
  result = sm_dsigned(result, sm_dsign(x) & odd);
  result = sm_dsel(result, sm_dof(SM_D_NOTHING), spu_andc(sm_dis_negative(x), whole | zero_or_infinite));
  result = sm_dkeep_nan(sm_dkeep_nan(result, x), y);
  return sm_dsel(result, SM_D2(1.0), sm_dis_zero(y) | sm_deq_words(sm_dwords(x), SM_D_ONE));
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
