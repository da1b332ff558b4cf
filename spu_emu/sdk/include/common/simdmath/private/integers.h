/* Whole numbers of 32 and 64 bits. A division by zero gives the quotient 0 and the dividend as rest. */
#ifndef SPU_EMU_SIMDMATH_INTEGERS_H
#define SPU_EMU_SIMDMATH_INTEGERS_H

#include "simdmath/private/vectors.h"

SM_INLINE vec_uint4 sm_umagnitude(vec_int4 x) {
  const vec_uint4 negative = (vec_uint4)(x >> 31);
  return ((vec_uint4)x ^ negative) - negative;
}

static inline vec_int4 _negatei4(vec_int4 x) {
  return (vec_int4)(SM_U4(0) - (vec_uint4)x);
}
static inline vec_int4 _absi4(vec_int4 x) {
  return (vec_int4)sm_umagnitude(x);
}

/* The quotient by a factor that is a little less than 1 / divisor; never too large. */
SM_INLINE vec_uint4 sm_uquotient_below(vec_uint4 a, vec_float4 recip) {
#ifdef __SPU__
  return spu_convtu(spu_mul(spu_convtf(a, 0), recip), 0);
#else
  return vec_ctu(sm_fmul(vec_ctf(a, 0), recip), 0);
#endif
}

static inline divu4_t _divu4(vec_uint4 dividend, vec_uint4 divisor) {
#ifdef __SPU__
  const vec_float4 d = spu_convtf(divisor, 0);
#else
  const vec_float4 d = vec_ctf(divisor, 0);
#endif
  const vec_float4 guess = sm_frecip_guess(d);
  const vec_float4 recip = sm_fmadd(guess, sm_fnmsub(d, guess, SM_F4(0x1.fffffp-1f)), guess);
  const vec_float4 below = sm_fmul(recip, SM_F4(0x1.fffff8p-1f));
  const vec_uint4 by_zero = sm_ueq(divisor, SM_U4(0));
  divu4_t result;
  int i;
  result.quot = SM_U4(0);
  result.rem = dividend;
  for (i = 0; i < 2; ++i) {
    const vec_uint4 part = sm_uquotient_below(result.rem, below) & ~by_zero;
    result.quot += part;
    result.rem -= part * divisor;
  }
  for (i = 0; i < 2; ++i) {
    const vec_uint4 one_more = ~(sm_ugt(divisor, result.rem) | by_zero);
    result.quot -= one_more;
    result.rem -= divisor & one_more;
  }
  return result;
}

static inline divi4_t _divi4(vec_int4 dividend, vec_int4 divisor) {
  const divu4_t magnitudes = _divu4(sm_umagnitude(dividend), sm_umagnitude(divisor));
  const vec_uint4 rest_sign = (vec_uint4)(dividend >> 31);
  const vec_uint4 sign = (vec_uint4)((dividend ^ divisor) >> 31);
  divi4_t result;
  result.quot = (vec_int4)((magnitudes.quot ^ sign) - sign);
  result.rem = (vec_int4)((magnitudes.rem ^ rest_sign) - rest_sign);
  return result;
}

static inline vec_llong2 _negatell2(vec_llong2 x) {
#ifdef __SPU__
  return (vec_llong2)((vec_ullong2){0, 0} - (vec_ullong2)x);
#else
  return sm_ll2((long long)(0 - (unsigned long long)sm_llat(x, 0)),
                (long long)(0 - (unsigned long long)sm_llat(x, 1)));
#endif
}

SM_INLINE unsigned long long sm_llmagnitude(long long x) {
  return x < 0 ? 0 - (unsigned long long)x : (unsigned long long)x;
}
static inline vec_llong2 _llabsi2(vec_llong2 x) {
  return sm_ll2((long long)sm_llmagnitude(sm_llat(x, 0)), (long long)sm_llmagnitude(sm_llat(x, 1)));
}

SM_INLINE unsigned long long sm_llquotient(unsigned long long dividend, unsigned long long divisor) {
  return divisor == 0 ? 0 : dividend / divisor;
}
static inline lldivu2_t _lldivu2(vec_ullong2 dividend, vec_ullong2 divisor) {
  const unsigned long long a0 = sm_ullat(dividend, 0), a1 = sm_ullat(dividend, 1);
  const unsigned long long b0 = sm_ullat(divisor, 0), b1 = sm_ullat(divisor, 1);
  const unsigned long long q0 = sm_llquotient(a0, b0), q1 = sm_llquotient(a1, b1);
  lldivu2_t result;
  result.quot = sm_ull2(q0, q1);
  result.rem = sm_ull2(a0 - q0 * b0, a1 - q1 * b1);
  return result;
}

SM_INLINE long long sm_llwith_sign(unsigned long long magnitude, int negative) {
  return (long long)(negative ? 0 - magnitude : magnitude);
}
static inline lldivi2_t _lldivi2(vec_llong2 dividend, vec_llong2 divisor) {
  const lldivu2_t magnitudes = _lldivu2((vec_ullong2)_llabsi2(dividend), (vec_ullong2)_llabsi2(divisor));
  const long long a0 = sm_llat(dividend, 0), a1 = sm_llat(dividend, 1);
  lldivi2_t result;
  result.quot = sm_ll2(sm_llwith_sign(sm_ullat(magnitudes.quot, 0), (a0 < 0) != (sm_llat(divisor, 0) < 0)),
                       sm_llwith_sign(sm_ullat(magnitudes.quot, 1), (a1 < 0) != (sm_llat(divisor, 1) < 0)));
  result.rem = sm_ll2(sm_llwith_sign(sm_ullat(magnitudes.rem, 0), a0 < 0),
                      sm_llwith_sign(sm_ullat(magnitudes.rem, 1), a1 < 0));
  return result;
}

#endif
