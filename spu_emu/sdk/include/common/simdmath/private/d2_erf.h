/* The error function of doubles and what it lacks to 1. */
#ifndef SPU_EMU_SIMDMATH_D2_ERF_H
#define SPU_EMU_SIMDMATH_D2_ERF_H

#include "simdmath/private/d2_exp_log.h"

#ifdef __SPU__

/* erfc(a) for a from 0 on: e^(-a^2) (1 + p) / (1 + 2 a), the square as two numbers. */
SM_INLINE vec_double2 sm_derfc_positive(vec_double2 magnitude) {
  const vec_double2 a = sm_dlimit(magnitude, SM_D2(28.0));
  const vec_double2 one = SM_D2(1.0);
  const vec_double2 square = sm_dmul(a, a);
  const vec_double2 square_low = sm_dmsub(a, a, square);
  const vec_double2 four = SM_D2(4.0);
  const vec_double2 p = sm_poly_erfc_d2(sm_ddivide(sm_dsub(a, four), sm_dadd(a, four)));
  vec_int4 power;
  vec_double2 minus_one = sm_dexp_parts(sm_dneg(square), &power);
  minus_one = sm_dnmsub(square_low, sm_dadd(minus_one, one), minus_one);
  minus_one = sm_dmadd(p, sm_dadd(minus_one, one), minus_one);
  return sm_dscale(sm_ddivide(sm_dadd(minus_one, one), sm_dmadd(SM_D2(2.0), a, one)), power);
}

/* erf(x) for |x| up to 1. */
SM_INLINE vec_double2 sm_derf_near(vec_double2 x) {
  return sm_dmadd(sm_poly_erf_d2(sm_dmul(x, x)), x, x);
}

static inline vec_double2 _erfd2(vec_double2 x) {
  const vec_uint4 near = sm_dabsgt(SM_D2(1.0), x);
  const vec_double2 of_near = sm_derf_near(sm_dmasked(x, near));
  const vec_double2 far = sm_dsigned(sm_dsub(SM_D2(1.0), sm_derfc_positive(sm_dabs(x))), sm_dsign(x));
  return sm_dkeep_nan(sm_dsel(far, of_near, near), x);
}

static inline vec_double2 _erfcd2(vec_double2 x) {
  const vec_uint4 near = sm_dabsgt(SM_D2(0.5), x);
  const vec_double2 of_near = sm_dsub(SM_D2(1.0), sm_derf_near(sm_dmasked(x, near)));
  const vec_double2 of_positive = sm_derfc_positive(sm_dabs(x));
  const vec_double2 far = sm_dsel(of_positive, sm_dsub(SM_D2(2.0), of_positive), sm_dis_negative(x));
  return sm_dkeep_nan(sm_dsel(far, of_near, near), x);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
