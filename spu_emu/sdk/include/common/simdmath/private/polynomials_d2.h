/* Polynomials of the SIMD math library, made by lib/simdmath/coefficients. */
#ifndef SPU_EMU_SIMDMATH_POLYNOMIALS_D2_H
#define SPU_EMU_SIMDMATH_POLYNOMIALS_D2_H

#include "simdmath/private/doubles.h"

/* exp(x) = 1 + x + x^2 p: 56.5 bits. */
SM_INLINE vec_double2 sm_poly_exp_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.ad7f4bed7a16ep-26);
  p = sm_dmadd(p, x, SM_D2(0x1.28ad8dc63c2a8p-22));
  p = sm_dmadd(p, x, SM_D2(0x1.71df25944b697p-19));
  p = sm_dmadd(p, x, SM_D2(0x1.a01999f092ae7p-16));
  p = sm_dmadd(p, x, SM_D2(0x1.a01a012a26df8p-13));
  p = sm_dmadd(p, x, SM_D2(0x1.6c16c18433c0ap-10));
  p = sm_dmadd(p, x, SM_D2(0x1.1111111127cacp-7));
  p = sm_dmadd(p, x, SM_D2(0x1.5555555550853p-5));
  p = sm_dmadd(p, x, SM_D2(0x1.55555555554fap-3));
  p = sm_dmadd(p, x, SM_D2(0x1.000000000000ap-1));
  return p;
}

/* log((1 + x) / (1 - x)) / 2 = x + x^3 p(x^2): 61.6 bits. */
SM_INLINE vec_double2 sm_poly_atanh_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.0f629c615b51fp-4);
  p = sm_dmadd(p, x, SM_D2(0x1.0f5cda1fefa3ap-4));
  p = sm_dmadd(p, x, SM_D2(0x1.3b20aa979236bp-4));
  p = sm_dmadd(p, x, SM_D2(0x1.745cde3cb30afp-4));
  p = sm_dmadd(p, x, SM_D2(0x1.c71c7258e1d3bp-4));
  p = sm_dmadd(p, x, SM_D2(0x1.249249242b5e1p-3));
  p = sm_dmadd(p, x, SM_D2(0x1.9999999999dfdp-3));
  p = sm_dmadd(p, x, SM_D2(0x1.5555555555555p-2));
  return p;
}

/* the same = x + x^3 / 3 + x^5 p(x^2): 66.3 bits. */
SM_INLINE vec_double2 sm_poly_atanh5_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.eb118e142d1e6p-5);
  p = sm_dmadd(p, x, SM_D2(0x1.de336a7c349acp-5));
  p = sm_dmadd(p, x, SM_D2(0x1.1120b59801165p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.3b1362b7b8d51p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.745d183246449p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.c71c71c580917p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.2492492493033p-3));
  p = sm_dmadd(p, x, SM_D2(0x1.9999999999996p-3));
  return p;
}

/* sin(x) = x + x^3 p(x^2): 56.4 bits. */
SM_INLINE vec_double2 sm_poly_sin_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.5d8f9534323b6p-33);
  p = sm_dmadd(p, x, SM_D2(-0x1.ae5e59c6f54a7p-26));
  p = sm_dmadd(p, x, SM_D2(0x1.71de3566d8ae3p-19));
  p = sm_dmadd(p, x, SM_D2(-0x1.a01a019bfcd7dp-13));
  p = sm_dmadd(p, x, SM_D2(0x1.111111110f7c8p-7));
  p = sm_dmadd(p, x, SM_D2(-0x1.5555555555548p-3));
  return p;
}

/* cos(x) = 1 - x^2 / 2 + x^4 p(x^2): 59.6 bits. */
SM_INLINE vec_double2 sm_poly_cos_d2(vec_double2 x) {
  vec_double2 p = SM_D2(-0x1.8fa4567a1eadap-37);
  p = sm_dmadd(p, x, SM_D2(0x1.1ee9d7356650ap-29));
  p = sm_dmadd(p, x, SM_D2(-0x1.27e4f7ea0db4dp-22));
  p = sm_dmadd(p, x, SM_D2(0x1.a01a019c83587p-16));
  p = sm_dmadd(p, x, SM_D2(-0x1.6c16c16c14f88p-10));
  p = sm_dmadd(p, x, SM_D2(0x1.555555555554bp-5));
  return p;
}

/* asin(x) = x + x^3 p(x^2): 59.2 bits. */
SM_INLINE vec_double2 sm_poly_asin_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.0b4b41a3e2551p-5);
  p = sm_dmadd(p, x, SM_D2(-0x1.580cb2f1b1c04p-6));
  p = sm_dmadd(p, x, SM_D2(0x1.63a7d218d8d7ap-6));
  p = sm_dmadd(p, x, SM_D2(0x1.e5cdc1210b8e3p-9));
  p = sm_dmadd(p, x, SM_D2(0x1.613f5ddc80da6p-7));
  p = sm_dmadd(p, x, SM_D2(0x1.7584fec87b548p-7));
  p = sm_dmadd(p, x, SM_D2(0x1.ca1f9ff073c93p-7));
  p = sm_dmadd(p, x, SM_D2(0x1.1c49ef82a427dp-6));
  p = sm_dmadd(p, x, SM_D2(0x1.6e8bdeede92fdp-6));
  p = sm_dmadd(p, x, SM_D2(0x1.f1c71a9463de2p-6));
  p = sm_dmadd(p, x, SM_D2(0x1.6db6db72142fdp-5));
  p = sm_dmadd(p, x, SM_D2(0x1.333333332e101p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.5555555555577p-3));
  return p;
}

/* atan(x) = x + x^3 p(x^2): 58.3 bits. */
SM_INLINE vec_double2 sm_poly_atan_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.f1e51e94bc906p-7);
  p = sm_dmadd(p, x, SM_D2(-0x1.12367d21f277cp-5));
  p = sm_dmadd(p, x, SM_D2(0x1.70ec95938f3abp-5));
  p = sm_dmadd(p, x, SM_D2(-0x1.ab7d4b1224eb8p-5));
  p = sm_dmadd(p, x, SM_D2(0x1.e171f666e6bfcp-5));
  p = sm_dmadd(p, x, SM_D2(-0x1.110c724153dfap-4));
  p = sm_dmadd(p, x, SM_D2(0x1.3b136e237b419p-4));
  p = sm_dmadd(p, x, SM_D2(-0x1.745d14b943438p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.c71c71b7474a1p-4));
  p = sm_dmadd(p, x, SM_D2(-0x1.249249247568bp-3));
  p = sm_dmadd(p, x, SM_D2(0x1.999999999964bp-3));
  p = sm_dmadd(p, x, SM_D2(-0x1.5555555555554p-2));
  return p;
}

/* cbrt(x) = p, a first guess: 16.7 bits. */
SM_INLINE vec_double2 sm_poly_cbrt_d2(vec_double2 x) {
  vec_double2 p = SM_D2(-0x1.5b77f08482c2dp-7);
  p = sm_dmadd(p, x, SM_D2(0x1.60a1536db54cap-4));
  p = sm_dmadd(p, x, SM_D2(-0x1.33d38504cc1bap-2));
  p = sm_dmadd(p, x, SM_D2(0x1.6fb1dfdf6a7aap-1));
  p = sm_dmadd(p, x, SM_D2(0x1.0392ccec998ccp-1));
  return p;
}

/* erf(x) = x + x p(x^2): 56.3 bits. */
SM_INLINE vec_double2 sm_poly_erf_d2(vec_double2 x) {
  vec_double2 p = SM_D2(-0x1.2928f057419c7p-38);
  p = sm_dmadd(p, x, SM_D2(0x1.7ecbf69b56258p-34));
  p = sm_dmadd(p, x, SM_D2(-0x1.4e55cc7e0371ap-30));
  p = sm_dmadd(p, x, SM_D2(0x1.fc41171118b59p-27));
  p = sm_dmadd(p, x, SM_D2(-0x1.5f6d6b5130adbp-23));
  p = sm_dmadd(p, x, SM_D2(0x1.b9e64d07bf417p-20));
  p = sm_dmadd(p, x, SM_D2(-0x1.f4d255e14619p-17));
  p = sm_dmadd(p, x, SM_D2(0x1.f9a326bfb7106p-14));
  p = sm_dmadd(p, x, SM_D2(-0x1.c02db3fed8f64p-11));
  p = sm_dmadd(p, x, SM_D2(0x1.565bcd0e64ab7p-8));
  p = sm_dmadd(p, x, SM_D2(-0x1.b82ce3128899bp-6));
  p = sm_dmadd(p, x, SM_D2(0x1.ce2f21a042bddp-4));
  p = sm_dmadd(p, x, SM_D2(-0x1.812746b0379e7p-2));
  p = sm_dmadd(p, x, SM_D2(0x1.06eba8214db69p-3));
  return p;
}

/* (1 + 2 y) e^(y^2) erfc(y) = 1 + p((y - 4) / (y + 4)): 55.3 bits. */
SM_INLINE vec_double2 sm_poly_erfc_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.49571634bd976p-30);
  p = sm_dmadd(p, x, SM_D2(0x1.cd0aff790e878p-30));
  p = sm_dmadd(p, x, SM_D2(-0x1.e3761b9373aacp-27));
  p = sm_dmadd(p, x, SM_D2(-0x1.2c204424edab1p-26));
  p = sm_dmadd(p, x, SM_D2(0x1.d9e065c6bdbb6p-24));
  p = sm_dmadd(p, x, SM_D2(0x1.3e47a53fcd85ep-24));
  p = sm_dmadd(p, x, SM_D2(-0x1.bb6ffb42a4d43p-21));
  p = sm_dmadd(p, x, SM_D2(0x1.3bda9652361bdp-22));
  p = sm_dmadd(p, x, SM_D2(0x1.7f346f59a077fp-18));
  p = sm_dmadd(p, x, SM_D2(-0x1.788dd16dfd346p-17));
  p = sm_dmadd(p, x, SM_D2(-0x1.995ace7bcd243p-16));
  p = sm_dmadd(p, x, SM_D2(0x1.3be06c0b45d76p-13));
  p = sm_dmadd(p, x, SM_D2(-0x1.a1df16156bc9ap-13));
  p = sm_dmadd(p, x, SM_D2(-0x1.8d4a9c4ddead2p-11));
  p = sm_dmadd(p, x, SM_D2(0x1.49c6726f02644p-8));
  p = sm_dmadd(p, x, SM_D2(-0x1.096238829b264p-6));
  p = sm_dmadd(p, x, SM_D2(0x1.3079edf6d4d4cp-5));
  p = sm_dmadd(p, x, SM_D2(-0x1.0fb06dfe55359p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.7fee004e0fdf1p-4));
  p = sm_dmadd(p, x, SM_D2(-0x1.9ddb23c3e8956p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.16ecefcfa54a5p-4));
  p = sm_dmadd(p, x, SM_D2(0x1.f7f5df66fd6ccp-7));
  p = sm_dmadd(p, x, SM_D2(-0x1.1df1ad154a28fp-3));
  p = sm_dmadd(p, x, SM_D2(0x1.dd2c8b74febf6p-3));
  return p;
}

#endif
