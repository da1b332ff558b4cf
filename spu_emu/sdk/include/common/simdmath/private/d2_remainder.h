/* Remainders of doubles, exact. */
#ifndef SPU_EMU_SIMDMATH_D2_REMAINDER_H
#define SPU_EMU_SIMDMATH_D2_REMAINDER_H

#include "simdmath/private/d2_basic.h"

#ifdef __SPU__

/* |x| = (quotient * divisor + rest) * 2^power, |y| = divisor * 2^power, with the last bits of the quotient.
 */
typedef struct sm_ddivision {
  unsigned int quotient;
  unsigned long long rest;
  unsigned long long divisor;
  int power;
} sm_ddivision;

SM_INLINE unsigned long long sm_dsignificand(vec_uint4 words, int i) {
  return ((unsigned long long)((spu_extract(words, 2 * i) & 0xfffffu) | 0x100000u) << 32) |
         spu_extract(words, 2 * i + 1);
}
SM_INLINE int sm_dexponent_of(vec_uint4 words, int i) {
  return (int)(spu_extract(words, 2 * i) >> 20 & 2047u);
}

static inline sm_ddivision sm_dlong_division(vec_uint4 x, vec_uint4 y, int i) {
  sm_ddivision d;
  int steps = sm_dexponent_of(x, i) - sm_dexponent_of(y, i);
  d.quotient = 0;
  d.rest = sm_dsignificand(x, i);
  d.divisor = sm_dsignificand(y, i);
  d.power = (steps < 0 ? sm_dexponent_of(x, i) : sm_dexponent_of(y, i)) - 1075;
  /* An x with the smaller exponent is the rest itself; from two less it is below half of y, however large
   * that is. */
  if (steps < 0) d.divisor = steps == -1 ? d.divisor << 1 : 1ull << 60;
  for (; steps >= 0; --steps) {
    d.quotient <<= 1;
    if (d.rest >= d.divisor) {
      d.rest -= d.divisor;
      d.quotient |= 1;
    }
    if (steps > 0) d.rest <<= 1;
  }
  return d;
}

/* rest * 2^power, which is exact where the result is not denormal. */
SM_INLINE vec_double2 sm_drest(const unsigned long long* rest, const int* power) {
  const vec_double2 whole = {(double)(long long)rest[0], (double)(long long)rest[1]};
  const vec_int4 both = {power[0], power[0], power[1], power[1]};
  vec_int4 exponent;
  const vec_double2 fraction = sm_dfrexp(whole, &exponent);
  return sm_dscale(fraction, exponent + both);
}

SM_INLINE vec_double2 sm_dremainder_of_specials(vec_double2 result, vec_double2 x, vec_double2 y) {
  vec_double2 known = sm_dsel(result, x, sm_dis_zero(x) | sm_dis_special(y));
  known = sm_dsel(known, sm_dof(SM_D_NOTHING), sm_dis_zero(y) | sm_dis_special(x));
  return sm_dkeep_nan(sm_dkeep_nan(known, x), y);
}

static inline vec_double2 _fmodd2(vec_double2 x, vec_double2 y) {
  unsigned long long rest[2];
  int power[2], i;
  for (i = 0; i < 2; ++i) {
    const sm_ddivision d = sm_dlong_division(sm_dwords(x), sm_dwords(y), i);
    rest[i] = d.rest;
    power[i] = d.power;
  }
  return sm_dremainder_of_specials(sm_dsigned(sm_drest(rest, power), sm_dsign(x)), x, y);
}

/* The quotient is the nearest, of two the even one; three of its bits come back, with its sign. */
static inline vec_double2 _remquod2(vec_double2 x, vec_double2 y, vec_llong2* quotient) {
  unsigned long long rest[2];
  int power[2], bits[2], i;
  vec_uint4 up = SM_U4(0);
  const vec_uint4 none = sm_dis_zero(x) | sm_dis_zero(y) | sm_dis_special(x) | sm_dis_special(y);
  const vec_uint4 negative = sm_dis_negative(sm_dof(sm_dwords(x) ^ sm_dwords(y)));
  vec_uint4 whole;
  for (i = 0; i < 2; ++i) {
    const sm_ddivision d = sm_dlong_division(sm_dwords(x), sm_dwords(y), i);
    const unsigned long long twice = d.rest << 1;
    const int is_up = twice > d.divisor || (twice == d.divisor && (d.quotient & 1u) != 0);
    rest[i] = is_up ? d.divisor - d.rest : d.rest;
    power[i] = d.power;
    bits[i] = (int)((d.quotient + (unsigned int)is_up) & 7u);
    if (is_up) up = spu_insert(0x80000000u, up, 2 * i);
  }
  whole = spu_andc((vec_uint4)((vec_int4){bits[0], bits[0], bits[1], bits[1]}), none);
  *quotient = sm_dlong((vec_int4)((whole ^ negative) - negative));
  return sm_dremainder_of_specials(sm_dof(sm_dwords(sm_drest(rest, power)) ^ sm_dsign(x) ^ up), x, y);
}
static inline vec_double2 _remainderd2(vec_double2 x, vec_double2 y) {
  vec_llong2 quotient;
  return _remquod2(x, y, &quotient);
}

#else
#include "simdmath/private/ppu_doubles.h"
#endif

#endif
