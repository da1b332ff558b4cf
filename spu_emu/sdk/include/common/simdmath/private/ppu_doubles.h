/* The double2 functions of the PPU. Its vector unit has no doubles; vec_types.h has a name for two of them
 * all the same, and a register holds them. They are worked on one by one, by the C library and the
 * floating-point unit, which knows denormals. */
#ifndef SPU_EMU_SIMDMATH_PPU_DOUBLES_H
#define SPU_EMU_SIMDMATH_PPU_DOUBLES_H

#include <float.h>
#include <limits.h>
#include <math.h>

#include "simdmath/private/types.h"

typedef union sm_doubles {
  vec_double2 all;
  double x[2];
} sm_doubles;

#define SM_PPU_1(name, function)                       \
  static inline vec_double2 _##name(vec_double2 x) {   \
    sm_doubles a = {x};                                \
    int i;                                             \
    for (i = 0; i < 2; ++i) a.x[i] = function(a.x[i]); \
    return a.all;                                      \
  }
#define SM_PPU_2(name, function)                                    \
  static inline vec_double2 _##name(vec_double2 x, vec_double2 y) { \
    sm_doubles a = {x}, b = {y};                                    \
    int i;                                                          \
    for (i = 0; i < 2; ++i) a.x[i] = function(a.x[i], b.x[i]);      \
    return a.all;                                                   \
  }
/* All bits of an element or none. */
#define SM_PPU_IS_1(name, predicate)                                  \
  static inline vec_ullong2 _##name(vec_double2 x) {                  \
    const sm_doubles a = {x};                                         \
    return sm_ull2(0 - (unsigned long long)(predicate(a.x[0]) != 0),  \
                   0 - (unsigned long long)(predicate(a.x[1]) != 0)); \
  }
#define SM_PPU_IS_2(name, predicate)                                          \
  static inline vec_ullong2 _##name(vec_double2 x, vec_double2 y) {           \
    const sm_doubles a = {x}, b = {y};                                        \
    return sm_ull2(0 - (unsigned long long)(predicate(a.x[0], b.x[0]) != 0),  \
                   0 - (unsigned long long)(predicate(a.x[1], b.x[1]) != 0)); \
  }
/* A number of 64 bits for each element. */
#define SM_PPU_TO_LONG(name, function)                 \
  static inline vec_llong2 _##name(vec_double2 x) {    \
    const sm_doubles a = {x};                          \
    return sm_ll2(function(a.x[0]), function(a.x[1])); \
  }

#define SM_NEGATE(x) (-(x))
#define SM_RECIP(x) (1.0 / (x))
#define SM_DIV(x, y) ((x) / (y))
#define SM_RSQRT(x) (1.0 / __builtin_fabs(__builtin_sqrt(x)))
#define SM_IS_0_DENORM(x) (__builtin_fabs(x) < DBL_MIN)
#define SM_IS_EQUAL(x, y) ((x) == (y))

SM_INLINE double sm_lgamma(double x) {
  int sign;
  return __builtin_lgamma_r(x, &sign);
}

/* Of two arguments the one that is a number; the C library asks whether the NaN is a quiet one. */
SM_INLINE double sm_fmax(double x, double y) {
  return __builtin_isnan(x) || y > x ? y : x;
}
SM_INLINE double sm_fmin(double x, double y) {
  return __builtin_isnan(x) || y < x ? y : x;
}
SM_INLINE double sm_hypot(double x, double y) {
  return __builtin_isinf(x) || __builtin_isinf(y) ? __builtin_inf() : __builtin_hypot(x, y);
}
SM_INLINE double sm_pow(double x, double y) {
  return x == 1 || y == 0 ? 1 : __builtin_pow(x, y);
}

SM_PPU_1(fabsd2, __builtin_fabs)
SM_PPU_1(negated2, SM_NEGATE)
SM_PPU_2(copysignd2, __builtin_copysign)
SM_PPU_IS_1(signbitd2, __builtin_signbit)
SM_PPU_IS_1(isnand2, __builtin_isnan)
SM_PPU_IS_1(isinfd2, __builtin_isinf)
SM_PPU_IS_1(isfinited2, __builtin_isfinite)
SM_PPU_IS_1(isnormald2, __builtin_isnormal)
SM_PPU_IS_1(is0denormd2, SM_IS_0_DENORM)
SM_PPU_IS_2(isequald2, SM_IS_EQUAL)
SM_PPU_IS_2(isgreaterd2, __builtin_isgreater)
SM_PPU_IS_2(isgreaterequald2, __builtin_isgreaterequal)
SM_PPU_IS_2(islessd2, __builtin_isless)
SM_PPU_IS_2(islessequald2, __builtin_islessequal)
SM_PPU_IS_2(islessgreaterd2, __builtin_islessgreater)
SM_PPU_IS_2(isunorderedd2, __builtin_isunordered)
SM_PPU_2(fmaxd2, sm_fmax)
SM_PPU_2(fmind2, sm_fmin)
SM_PPU_2(fdimd2, __builtin_fdim)
SM_PPU_1(truncd2, __builtin_trunc)
SM_PPU_1(floord2, __builtin_floor)
SM_PPU_1(ceild2, __builtin_ceil)
SM_PPU_1(roundd2, __builtin_round)
SM_PPU_1(rintd2, __builtin_rint)
SM_PPU_1(nearbyintd2, __builtin_nearbyint)
SM_PPU_1(logbd2, __builtin_logb)
SM_PPU_2(nextafterd2, __builtin_nextafter)
SM_PPU_2(divd2, SM_DIV)
SM_PPU_2(hypotd2, sm_hypot)
SM_PPU_1(recipd2, SM_RECIP)
SM_PPU_1(sqrtd2, __builtin_sqrt)
SM_PPU_1(rsqrtd2, SM_RSQRT)
SM_PPU_1(cbrtd2, __builtin_cbrt)
SM_PPU_2(fmodd2, __builtin_fmod)
SM_PPU_2(remainderd2, __builtin_remainder)
SM_PPU_1(expd2, __builtin_exp)
SM_PPU_1(exp2d2, __builtin_exp2)
SM_PPU_1(expm1d2, __builtin_expm1)
SM_PPU_1(logd2, __builtin_log)
SM_PPU_1(log2d2, __builtin_log2)
SM_PPU_1(log10d2, __builtin_log10)
SM_PPU_1(log1pd2, __builtin_log1p)
SM_PPU_2(powd2, sm_pow)
SM_PPU_1(sind2, __builtin_sin)
SM_PPU_1(cosd2, __builtin_cos)
SM_PPU_1(tand2, __builtin_tan)
SM_PPU_1(asind2, __builtin_asin)
SM_PPU_1(acosd2, __builtin_acos)
SM_PPU_1(atand2, __builtin_atan)
SM_PPU_2(atan2d2, __builtin_atan2)
SM_PPU_1(sinhd2, __builtin_sinh)
SM_PPU_1(coshd2, __builtin_cosh)
SM_PPU_1(tanhd2, __builtin_tanh)
SM_PPU_1(asinhd2, __builtin_asinh)
SM_PPU_1(acoshd2, __builtin_acosh)
SM_PPU_1(atanhd2, __builtin_atanh)
SM_PPU_1(erfd2, __builtin_erf)
SM_PPU_1(erfcd2, __builtin_erfc)
SM_PPU_1(lgammad2, sm_lgamma)
SM_PPU_1(tgammad2, __builtin_tgamma)

static inline vec_double2 _fmad2(vec_double2 x, vec_double2 y, vec_double2 z) {
  sm_doubles a = {x}, b = {y}, c = {z};
  int i;
  for (i = 0; i < 2; ++i) a.x[i] = __builtin_fma(a.x[i], b.x[i], c.x[i]);
  return a.all;
}

SM_INLINE long long sm_fpclassify(double x) {
  return __builtin_fpclassify(FP_NAN, FP_INFINITE, FP_NORMAL, FP_SUBNORMAL, FP_ZERO, x);
}
SM_INLINE long long sm_ilogb(double x) {
  if (x == 0) return INT_MIN;
  return __builtin_isfinite(x) ? __builtin_ilogb(x) : INT_MAX;
}
/* A double that is whole, limited to what 64 bits hold; of a NaN the limit of its sign. */
SM_INLINE long long sm_limited_to_ll(double x) {
  if (__builtin_fabs(x) < 0x1p63) return (long long)x;
  return __builtin_signbit(x) ? LLONG_MIN : LLONG_MAX;
}
SM_INLINE long long sm_llrint(double x) {
  return sm_limited_to_ll(__builtin_rint(x));
}
SM_INLINE long long sm_llround(double x) {
  return sm_limited_to_ll(__builtin_round(x));
}
SM_PPU_TO_LONG(fpclassifyd2, sm_fpclassify)
SM_PPU_TO_LONG(ilogbd2, sm_ilogb)
SM_PPU_TO_LONG(llrintd2, sm_llrint)
SM_PPU_TO_LONG(llroundd2, sm_llround)

static inline vec_double2 _modfd2(vec_double2 x, vec_double2* whole) {
  sm_doubles a = {x}, b;
  int i;
  for (i = 0; i < 2; ++i) a.x[i] = __builtin_modf(a.x[i], &b.x[i]);
  *whole = b.all;
  return a.all;
}
static inline vec_double2 _frexpd2(vec_double2 x, vec_llong2* exponent) {
  sm_doubles a = {x};
  int powers[2] = {0, 0}, i;
  for (i = 0; i < 2; ++i) {
    const int finite = __builtin_isfinite(a.x[i]);
    a.x[i] = __builtin_frexp(a.x[i], &powers[i]);
    if (!finite) powers[i] = 0;
  }
  *exponent = sm_ll2(powers[0], powers[1]);
  return a.all;
}
static inline vec_double2 _ldexpd2(vec_double2 x, vec_llong2 power) {
  sm_doubles a = {x};
  int i;
  for (i = 0; i < 2; ++i) {
    const long long wanted = sm_llat(power, i);
    a.x[i] = __builtin_scalbn(a.x[i], wanted < -3000 ? -3000 : wanted > 3000 ? 3000 : (int)wanted);
  }
  return a.all;
}
static inline vec_double2 _scalbllnd2(vec_double2 x, vec_llong2 power) {
  return _ldexpd2(x, power);
}
/* Three bits of the quotient with its sign. */
static inline vec_double2 _remquod2(vec_double2 x, vec_double2 y, vec_llong2* quotient) {
  sm_doubles a = {x}, b = {y};
  int quotients[2] = {0, 0}, i;
  for (i = 0; i < 2; ++i) {
    const int none = !__builtin_isfinite(a.x[i]) || !__builtin_isfinite(b.x[i]) || b.x[i] == 0;
    a.x[i] = __builtin_remquo(a.x[i], b.x[i], &quotients[i]);
    quotients[i] = none ? 0 : quotients[i] % 8;
  }
  *quotient = sm_ll2(quotients[0], quotients[1]);
  return a.all;
}
static inline void _sincosd2(vec_double2 x, vec_double2* sine, vec_double2* cosine) {
  *sine = _sind2(x);
  *cosine = _cosd2(x);
}

#undef SM_PPU_1
#undef SM_PPU_2
#undef SM_PPU_IS_1
#undef SM_PPU_IS_2
#undef SM_PPU_TO_LONG

#endif
