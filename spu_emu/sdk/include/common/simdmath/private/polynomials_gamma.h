/* Polynomials of the SIMD math library, made by lib/simdmath/coefficients. */
#ifndef SPU_EMU_SIMDMATH_POLYNOMIALS_GAMMA_H
#define SPU_EMU_SIMDMATH_POLYNOMIALS_GAMMA_H

#include "simdmath/private/doubles.h"

/* log(gamma(y)) = (y - 1) (y - 2) p(y - 7/4), y from 1 to 5/2: 54.5 bits. */
SM_INLINE vec_double2 sm_poly_lgamma_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.f4cbf8edc33b6p-26);
  p = sm_dmadd(p, x, SM_D2(-0x1.c4c80c5f4d5c4p-25));
  p = sm_dmadd(p, x, SM_D2(-0x1.06240aa178238p-26));
  p = sm_dmadd(p, x, SM_D2(0x1.d3189dbcfc448p-26));
  p = sm_dmadd(p, x, SM_D2(0x1.291400c14958dp-23));
  p = sm_dmadd(p, x, SM_D2(-0x1.0e06341228f94p-22));
  p = sm_dmadd(p, x, SM_D2(0x1.257213af5a776p-22));
  p = sm_dmadd(p, x, SM_D2(-0x1.0d2594c4dfa2dp-21));
  p = sm_dmadd(p, x, SM_D2(0x1.173c1ec062edep-20));
  p = sm_dmadd(p, x, SM_D2(-0x1.00caa371a2f9bp-19));
  p = sm_dmadd(p, x, SM_D2(0x1.d29b15c821a33p-19));
  p = sm_dmadd(p, x, SM_D2(-0x1.afaa62cab1b47p-18));
  p = sm_dmadd(p, x, SM_D2(0x1.91376b6228af2p-17));
  p = sm_dmadd(p, x, SM_D2(-0x1.75d6dcb9ea2e8p-16));
  p = sm_dmadd(p, x, SM_D2(0x1.5dd6de6340730p-15));
  p = sm_dmadd(p, x, SM_D2(-0x1.491775bdc103fp-14));
  p = sm_dmadd(p, x, SM_D2(0x1.377669ad69c91p-13));
  p = sm_dmadd(p, x, SM_D2(-0x1.28f268c3a3698p-12));
  p = sm_dmadd(p, x, SM_D2(0x1.1daed5a9d9909p-11));
  p = sm_dmadd(p, x, SM_D2(-0x1.16056269c6403p-10));
  p = sm_dmadd(p, x, SM_D2(0x1.12aa72f7b0764p-9));
  p = sm_dmadd(p, x, SM_D2(-0x1.14f7c58ebc36ap-8));
  p = sm_dmadd(p, x, SM_D2(0x1.1f9587fa1d99dp-7));
  p = sm_dmadd(p, x, SM_D2(-0x1.382e176f60a22p-6));
  p = sm_dmadd(p, x, SM_D2(0x1.6cb6251711902p-5));
  p = sm_dmadd(p, x, SM_D2(-0x1.e96586307946ep-4));
  p = sm_dmadd(p, x, SM_D2(0x1.ccf151e09cde8p-2));
  return p;
}

/* 1 / gamma(y) = p(y - 7/4), y from 1 to 5/2: 53.1 bits. */
SM_INLINE vec_double2 sm_poly_rgamma_d2(vec_double2 x) {
  vec_double2 p = SM_D2(-0x1.24c5fab6d0980p-35);
  p = sm_dmadd(p, x, SM_D2(-0x1.7af7e0b603950p-30));
  p = sm_dmadd(p, x, SM_D2(0x1.9a86e34c61f86p-27));
  p = sm_dmadd(p, x, SM_D2(-0x1.253691e1f78d9p-25));
  p = sm_dmadd(p, x, SM_D2(-0x1.4623c9afbaa63p-23));
  p = sm_dmadd(p, x, SM_D2(0x1.05e5a8539a261p-19));
  p = sm_dmadd(p, x, SM_D2(-0x1.fbc12507cddeep-18));
  p = sm_dmadd(p, x, SM_D2(-0x1.0cfcd8ac06f24p-18));
  p = sm_dmadd(p, x, SM_D2(0x1.6fd47ea14e0b7p-13));
  p = sm_dmadd(p, x, SM_D2(-0x1.7dd13669f445ep-11));
  p = sm_dmadd(p, x, SM_D2(0x1.1ea8420d3c78dp-12));
  p = sm_dmadd(p, x, SM_D2(0x1.19a755c1eeeb8p-7));
  p = sm_dmadd(p, x, SM_D2(-0x1.f129ffc8a0f44p-6));
  p = sm_dmadd(p, x, SM_D2(0x1.5e8225702ffd4p-8));
  p = sm_dmadd(p, x, SM_D2(0x1.9dbd240d8de14p-3));
  p = sm_dmadd(p, x, SM_D2(-0x1.878e31c389c76p-2));
  p = sm_dmadd(p, x, SM_D2(-0x1.13ba834a396d5p-2));
  p = sm_dmadd(p, x, SM_D2(0x1.168b71c1d1142p+0));
  return p;
}

/* log(gamma(x)) = (x - 1/2) log(x) - x + log(2 pi) / 2 + p(1 / x^2) / x, x from 8 on: 54.0 bits. */
SM_INLINE vec_double2 sm_poly_stirling_d2(vec_double2 x) {
  vec_double2 p = SM_D2(0x1.4bffc9d8a140bp-8);
  p = sm_dmadd(p, x, SM_D2(-0x1.ef8d748ae72d4p-10));
  p = sm_dmadd(p, x, SM_D2(0x1.b92c33f944377p-11));
  p = sm_dmadd(p, x, SM_D2(-0x1.38134d4f88969p-11));
  p = sm_dmadd(p, x, SM_D2(0x1.a01a017dcf9e1p-11));
  p = sm_dmadd(p, x, SM_D2(-0x1.6c16c16c149f4p-9));
  p = sm_dmadd(p, x, SM_D2(0x1.5555555555555p-4));
  return p;
}

#endif
