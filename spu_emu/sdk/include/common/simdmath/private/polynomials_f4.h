/* Polynomials of the SIMD math library, made by lib/simdmath/coefficients. */
#ifndef SPU_EMU_SIMDMATH_POLYNOMIALS_F4_H
#define SPU_EMU_SIMDMATH_POLYNOMIALS_F4_H

#include "simdmath/private/vectors.h"

/* exp(x) = 1 + x + x^2 p: 28 bits. */
SM_INLINE vec_float4 sm_poly_exp_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.6a23f2p-10);
  p = sm_fmadd(p, x, SM_F4(0x1.123a0ap-7));
  p = sm_fmadd(p, x, SM_F4(0x1.5558f2p-5));
  p = sm_fmadd(p, x, SM_F4(0x1.555492p-3));
  p = sm_fmadd(p, x, SM_F4(0x1.fffffcp-2));
  return p;
}

/* 2^x = 1 + x p: 25.9 bits. */
SM_INLINE vec_float4 sm_poly_exp2_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.41fbbcp-13);
  p = sm_fmadd(p, x, SM_F4(0x1.5f3e52p-10));
  p = sm_fmadd(p, x, SM_F4(0x1.3b2d4cp-7));
  p = sm_fmadd(p, x, SM_F4(0x1.c6aee8p-5));
  p = sm_fmadd(p, x, SM_F4(0x1.ebfbdcp-3));
  p = sm_fmadd(p, x, SM_F4(0x1.62e43p-1));
  return p;
}

/* log(1 + x) = x - x^2 / 2 + x^3 p: 27.2 bits. */
SM_INLINE vec_float4 sm_poly_log_f4(vec_float4 x) {
  vec_float4 p = SM_F4(-0x1.38b588p-4);
  p = sm_fmadd(p, x, SM_F4(0x1.055b6cp-3));
  p = sm_fmadd(p, x, SM_F4(-0x1.0d8542p-3));
  p = sm_fmadd(p, x, SM_F4(0x1.22da1cp-3));
  p = sm_fmadd(p, x, SM_F4(-0x1.547244p-3));
  p = sm_fmadd(p, x, SM_F4(0x1.99a008p-3));
  p = sm_fmadd(p, x, SM_F4(-0x1.000226p-2));
  p = sm_fmadd(p, x, SM_F4(0x1.555554p-2));
  return p;
}

/* log((1 + x) / (1 - x)) / 2 = x + x^3 p(x^2): 31.1 bits. */
SM_INLINE vec_float4 sm_poly_atanh_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.e2f52ep-4);
  p = sm_fmadd(p, x, SM_F4(0x1.2438e2p-3));
  p = sm_fmadd(p, x, SM_F4(0x1.999a7ap-3));
  p = sm_fmadd(p, x, SM_F4(0x1.555554p-2));
  return p;
}

/* sin(x) = x + x^3 p(x^2): 28 bits. */
SM_INLINE vec_float4 sm_poly_sin_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.6cd19ep-19);
  p = sm_fmadd(p, x, SM_F4(-0x1.a00f7ep-13));
  p = sm_fmadd(p, x, SM_F4(0x1.111108p-7));
  p = sm_fmadd(p, x, SM_F4(-0x1.555556p-3));
  return p;
}

/* cos(x) = 1 - x^2 / 2 + x^4 p(x^2): 32.6 bits. */
SM_INLINE vec_float4 sm_poly_cos_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.99eb32p-16);
  p = sm_fmadd(p, x, SM_F4(-0x1.6c0c32p-10));
  p = sm_fmadd(p, x, SM_F4(0x1.55554ap-5));
  return p;
}

/* asin(x) = x + x^3 p(x^2): 29.8 bits. */
SM_INLINE vec_float4 sm_poly_asin_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.3355c2p-5);
  p = sm_fmadd(p, x, SM_F4(0x1.d91fa4p-7));
  p = sm_fmadd(p, x, SM_F4(0x1.0491a2p-5));
  p = sm_fmadd(p, x, SM_F4(0x1.6caed2p-5));
  p = sm_fmadd(p, x, SM_F4(0x1.33387cp-4));
  p = sm_fmadd(p, x, SM_F4(0x1.55554cp-3));
  return p;
}

/* atan(x) = x + x^3 p(x^2): 28.3 bits. */
SM_INLINE vec_float4 sm_poly_atan_f4(vec_float4 x) {
  vec_float4 p = SM_F4(-0x1.f1ed8ap-5);
  p = sm_fmadd(p, x, SM_F4(0x1.b1ec3p-4));
  p = sm_fmadd(p, x, SM_F4(-0x1.23b522p-3));
  p = sm_fmadd(p, x, SM_F4(0x1.999196p-3));
  p = sm_fmadd(p, x, SM_F4(-0x1.55554ap-2));
  return p;
}

/* sinh(x) = x + x^3 p(x^2): 27.5 bits. */
SM_INLINE vec_float4 sm_poly_sinh_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.7a15b4p-19);
  p = sm_fmadd(p, x, SM_F4(0x1.9ffe92p-13));
  p = sm_fmadd(p, x, SM_F4(0x1.111134p-7));
  p = sm_fmadd(p, x, SM_F4(0x1.555556p-3));
  return p;
}

/* tanh(x) = x + x^3 p(x^2): 28.5 bits. */
SM_INLINE vec_float4 sm_poly_tanh_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.18e1dep-9);
  p = sm_fmadd(p, x, SM_F4(-0x1.0bf4fep-7));
  p = sm_fmadd(p, x, SM_F4(0x1.638b58p-6));
  p = sm_fmadd(p, x, SM_F4(-0x1.b9ee9p-5));
  p = sm_fmadd(p, x, SM_F4(0x1.111066p-3));
  p = sm_fmadd(p, x, SM_F4(-0x1.555554p-2));
  return p;
}

/* cbrt(x) = p, a first guess: 13.7 bits. */
SM_INLINE vec_float4 sm_poly_cbrt_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.7a8d3ep-6);
  p = sm_fmadd(p, x, SM_F4(-0x1.4dc30cp-3));
  p = sm_fmadd(p, x, SM_F4(0x1.2c9a3ep-1));
  p = sm_fmadd(p, x, SM_F4(0x1.1b0bacp-1));
  return p;
}

/* erf(x) = x + x p(x^2): 28.6 bits. */
SM_INLINE vec_float4 sm_poly_erf_f4(vec_float4 x) {
  vec_float4 p = SM_F4(0x1.496a32p-14);
  p = sm_fmadd(p, x, SM_F4(-0x1.a3f7p-11));
  p = sm_fmadd(p, x, SM_F4(0x1.5405b2p-8));
  p = sm_fmadd(p, x, SM_F4(-0x1.b7f90ep-6));
  p = sm_fmadd(p, x, SM_F4(0x1.ce2cf8p-4));
  p = sm_fmadd(p, x, SM_F4(-0x1.81273ep-2));
  p = sm_fmadd(p, x, SM_F4(0x1.06eba8p-3));
  return p;
}

/* (1 + 2 y) e^(y^2) erfc(y) = 1 + p((y - 4) / (y + 4)): 25.9 bits. */
SM_INLINE vec_float4 sm_poly_erfc_f4(vec_float4 x) {
  vec_float4 p = SM_F4(-0x1.4b5792p-11);
  p = sm_fmadd(p, x, SM_F4(-0x1.210fcap-10));
  p = sm_fmadd(p, x, SM_F4(0x1.4d105p-8));
  p = sm_fmadd(p, x, SM_F4(-0x1.065f24p-6));
  p = sm_fmadd(p, x, SM_F4(0x1.30d5bep-5));
  p = sm_fmadd(p, x, SM_F4(-0x1.0fd0cep-4));
  p = sm_fmadd(p, x, SM_F4(0x1.7fe256p-4));
  p = sm_fmadd(p, x, SM_F4(-0x1.9dd8f2p-4));
  p = sm_fmadd(p, x, SM_F4(0x1.16edcep-4));
  p = sm_fmadd(p, x, SM_F4(0x1.f7f56ap-7));
  p = sm_fmadd(p, x, SM_F4(-0x1.1df1bp-3));
  p = sm_fmadd(p, x, SM_F4(0x1.dd2c8cp-3));
  return p;
}

#endif
