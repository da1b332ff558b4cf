/* The gamma function of doubles and the logarithm of its magnitude.
 *
 * From 8 on both are Stirling's series, its logarithm as two numbers. Below, gamma(x) is that of y between 1
 * and 5/2, as many whole steps away, and a product. Below -1/2 it is by reflection: gamma(-a) = -pi / (a
 * sin(pi a) gamma(a)). */
#ifndef SPU_EMU_SIMDMATH_D2_GAMMA_H
#define SPU_EMU_SIMDMATH_D2_GAMMA_H

#include "simdmath/private/d2_exp_log.h"
#include "simdmath/private/d2_trig.h"

#ifdef __SPU__

#include "simdmath/private/polynomials_gamma.h"

/* a * b, b being one number. */
SM_INLINE sm_dpair sm_dtimes(sm_dpair a, vec_double2 b) {
  sm_dpair product;
  product.high = sm_dmul(a.high, b);
  product.low = sm_dmadd(a.low, b, sm_dmsub(a.high, b, product.high));
  return product;
}
SM_INLINE sm_dpair sm_dpair_sel(sm_dpair a, sm_dpair b, vec_uint4 mask) {
  a.high = sm_dsel(a.high, b.high, mask);
  a.low = sm_dsel(a.low, b.low, mask);
  return a;
}

/* x and what is y, between 1 and 5/2, for x from -1/2 to 8. */
typedef struct sm_dsteps {
  vec_double2 y_less_one;
  vec_double2 y_less_two;
  vec_uint4 up;     /* gamma(y) is product * gamma(x), */
  sm_dpair product; /* elsewhere gamma(x) is product * gamma(y). */
} sm_dsteps;

SM_INLINE sm_dsteps sm_dgamma_steps(vec_double2 x) {
  const vec_double2 one = SM_D2(1.0);
  const vec_uint4 two_up = sm_dgt(SM_D2(0.5), x);
  const vec_double2 below = sm_dsub(x, one);
  const vec_double2 above = sm_dadd(x, one);
  sm_dsteps steps;
  sm_dpair of_two_up;
  int i;
  steps.up = sm_dgt(one, x);
  steps.product.high = sm_dsel(one, x, steps.up);
  steps.product.low = SM_D2(0.0);
  /* x (x + 1), the sum as two numbers. */
  of_two_up.high = above;
  of_two_up.low = sm_dsub(x, sm_dsub(above, one));
  of_two_up = sm_dtimes(of_two_up, x);
  steps.product = sm_dpair_sel(steps.product, of_two_up, two_up);
  steps.y_less_one = sm_dsel(sm_dsel(below, x, steps.up), above, two_up);
  steps.y_less_two = sm_dsel(sm_dsel(sm_dsub(x, SM_D2(2.0)), below, steps.up), x, two_up);
  for (i = 0; i < 6; ++i) {
    const vec_uint4 down = sm_dgt(steps.y_less_one, SM_D2(1.5));
    steps.product = sm_dpair_sel(steps.product, sm_dtimes(steps.product, steps.y_less_one), down);
    steps.y_less_one = sm_dsel(steps.y_less_one, steps.y_less_two, down);
    steps.y_less_two = sm_dsub(steps.y_less_two, sm_dmasked(one, down));
  }
  return steps;
}
SM_INLINE vec_double2 sm_dfrom_middle(sm_dsteps steps) {
  return sm_dsub(steps.y_less_one, SM_D2(0.75));
}

/* Stirling's series to base 2 from the logarithm of x: (x - 1/2) (log2(x) - log2(e)) and what is small. */
SM_INLINE sm_dpair sm_dlog2_of_stirling(vec_double2 x, sm_dpair log2) {
  const sm_dpair log2e = sm_dpair_of(0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56);
  const vec_double2 recip = sm_dreciprocal(sm_dsel(x, SM_D2(0x1p80), sm_dabsgt(x, SM_D2(0x1p80))));
  const vec_double2 series = sm_dmul(recip, sm_poly_stirling_d2(sm_dmul(recip, recip)));
  const vec_double2 half_less = sm_dsub(x, SM_D2(0.5));
  sm_dpair sum;
  sum = sm_dquick_sum(log2.high, sm_dneg(log2e.high), sm_dsub(log2.low, log2e.low));
  sum = sm_dtimes(sum, half_less);
  /* (log(2 pi) - 1) / 2 to base 2. */
  return sm_dquick_sum(sum.high, SM_D2(0x1.3573fcf6d5af9p-1),
                       sm_dadd(sum.low, sm_dmadd(series, log2e.high, SM_D2(0x1.0e57879459ce1p-55))));
}

/* |sin(pi a)| for a from 0 on, and where the whole part of a is odd. */
SM_INLINE vec_double2 sm_dsine_of_half_turns(vec_double2 a, vec_uint4* odd) {
  const vec_double2 whole = _truncd2(a);
  const vec_double2 rest = sm_dsub(a, whole);
  const vec_double2 folded = sm_dsel(rest, sm_dsub(SM_D2(1.0), rest), sm_dabsgt(rest, SM_D2(0.5)));
  const vec_uint4 of_cosine = sm_dabsgt(folded, SM_D2(0.25));
  const vec_double2 turns = sm_dsel(folded, sm_dsub(SM_D2(0.5), folded), of_cosine);
  const vec_double2 pi = SM_D2(0x1.921fb54442d18p+1);
  sm_dangle angle;
  angle.quarter = SM_U4(0);
  angle.high = sm_dmul(turns, pi);
  angle.low = sm_dmadd(turns, SM_D2(0x1.1a62633145c07p-53), sm_dmsub(turns, pi, angle.high));
  *odd = sm_dhas_fraction(sm_dmul(whole, SM_D2(0.5)));
  return sm_dsel(sm_dsin_near(angle), sm_dcos_near(angle), of_cosine);
}

/* Of x from -1/2 on. */
SM_INLINE vec_double2 sm_dlgamma_positive(vec_double2 x) {
  const vec_uint4 far = sm_dgt(x, SM_D2(8.0));
  const sm_dpair ln2 = sm_dpair_of(0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56);
  const sm_dsteps steps = sm_dgamma_steps(sm_dmasked(x, ~far));
  const sm_dpair log2 = sm_dlog2_pair(sm_dsel(sm_dabs(steps.product.high), x, far));
  /* To base 2 the largest would not fit. */
  const vec_uint4 huge = sm_dabsgt(x, SM_D2(0x1p1000));
  const vec_double2 shrunk = sm_dsel(x, sm_dmul(x, SM_D2(0x1p-8)), huge);
  const sm_dpair far_log = sm_dproduct(sm_dlog2_of_stirling(shrunk, log2), ln2);
  const sm_dpair product_log = sm_dproduct(log2, ln2);
  const vec_double2 of_y =
      sm_dmul(sm_dmul(steps.y_less_one, steps.y_less_two), sm_poly_lgamma_d2(sm_dfrom_middle(steps)));
  const vec_uint4 signs = steps.up & SM_D_SIGN;
  const vec_double2 high = sm_dof(sm_dwords(product_log.high) ^ signs);
  const vec_double2 low = sm_dof(sm_dwords(product_log.low) ^ signs);
  const vec_double2 near_log = sm_dadd(high, sm_dadd(low, of_y));
  const vec_double2 far_sum = sm_dadd(far_log.high, far_log.low);
  return sm_dsel(near_log, sm_dmul(far_sum, sm_dsel(SM_D2(1.0), SM_D2(0x1p8), huge)), far);
}

static inline vec_double2 _lgammad2(vec_double2 x) {
  const vec_uint4 reflected = sm_dgt(SM_D2(-0.5), x);
  const vec_uint4 too_large = sm_dabsgt(x, SM_D2(0x1.754d9278b51a6p+1014)) | sm_dis_infinite(x);
  const vec_double2 limited = sm_dsel(x, SM_D2(3.0), too_large | sm_dis_nan(x));
  const vec_double2 a = sm_dsel(limited, sm_dneg(limited), reflected);
  vec_double2 result = sm_dlgamma_positive(a);
  if (sm_any(reflected)) {
    vec_uint4 odd;
    vec_int4 exponent;
    const vec_double2 sine = sm_dsine_of_half_turns(a, &odd);
    const vec_double2 f = sm_dlog_parts(sm_dmul(a, sine), &exponent);
    const vec_double2 log = sm_dlog_sum(f, SM_D2(0.0), exponent);
    const vec_double2 other = sm_dsub(sm_dsub(SM_D2(0x1.250d048e7a1bdp+0), log), result);
    const vec_double2 at_pole = sm_dsel(other, sm_dof(SM_D_HUGE), sm_dis_zero(sine));
    result = sm_dsel(result, at_pole, reflected);
  }
  result = sm_dsel(result, sm_dof(SM_D_HUGE), too_large | sm_dis_zero(x));
  return sm_dkeep_nan(result, x);
}

/* gamma(x) = above / below * 2^power, of x from -1/2 on. */
typedef struct sm_dfraction {
  vec_double2 above;
  vec_double2 below;
  vec_int4 power;
} sm_dfraction;

SM_INLINE sm_dfraction sm_dgamma_positive(vec_double2 x) {
  const vec_uint4 far = sm_dgt(x, SM_D2(8.0));
  const sm_dsteps steps = sm_dgamma_steps(sm_dmasked(x, ~far));
  const vec_double2 recip = sm_poly_rgamma_d2(sm_dfrom_middle(steps));
  const vec_double2 product = sm_dadd(steps.product.high, steps.product.low);
  const vec_double2 limited = sm_dsel(SM_D2(9.0), sm_dsel(x, SM_D2(250.0), sm_dabsgt(x, SM_D2(250.0))), far);
  const sm_dpair log2 = sm_dlog2_of_stirling(limited, sm_dlog2_pair(limited));
  vec_int4 power;
  const vec_double2 stirling = sm_dexp2_parts(log2.high, log2.low, &power);
  sm_dfraction result;
  result.above = sm_dsel(sm_dsel(product, SM_D2(1.0), steps.up), stirling, far);
  result.below = sm_dsel(sm_dsel(recip, sm_dmul(recip, product), steps.up), SM_D2(1.0), far);
  result.power = (vec_int4)((vec_uint4)power & far);
  return result;
}

static inline vec_double2 _tgammad2(vec_double2 x) {
  const vec_uint4 reflected = sm_dgt(SM_D2(-0.5), x);
  const vec_uint4 special = sm_dis_special(x);
  const vec_double2 limited = sm_dsel(x, SM_D2(3.0), special);
  const vec_double2 a = sm_dsel(limited, sm_dneg(limited), reflected);
  sm_dfraction gamma = sm_dgamma_positive(a);
  vec_double2 result;
  if (sm_any(reflected)) {
    vec_uint4 odd;
    const vec_double2 sine = sm_dsine_of_half_turns(a, &odd);
    const vec_double2 signed_pi = sm_dof(sm_dwords(SM_D2(0x1.921fb54442d18p+1)) | (SM_D_SIGN & ~odd));
    const vec_double2 above = sm_dmul(signed_pi, gamma.below);
    gamma.below = sm_dsel(gamma.below, sm_dmul(sm_dmul(a, sine), gamma.above), reflected);
    gamma.above = sm_dsel(gamma.above, above, reflected);
    gamma.power = (vec_int4)sm_usel((vec_uint4)gamma.power, (vec_uint4)(SM_I4(0) - gamma.power), reflected);
    gamma.above = sm_dsel(gamma.above, sm_dof(SM_D_NOTHING), reflected & sm_dis_zero(sine));
  }
  result = sm_dscale(_divd2(gamma.above, gamma.below), gamma.power);
  result = sm_dsel(result, sm_dof(SM_D_HUGE), sm_deq_words(sm_dwords(x), SM_D_HUGE));
  result = sm_dsel(result, sm_dof(SM_D_NOTHING), sm_deq_words(sm_dwords(x), SM_D_HUGE | SM_D_SIGN));
  result = sm_dsel(result, sm_dof(SM_D_HUGE | sm_dsign(x)), sm_dis_zero(x));
  return sm_dkeep_nan(result, x);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
