/* Signs and kinds of numbers. */
#ifndef SPU_EMU_SIMDMATH_F4_SIGN_H
#define SPU_EMU_SIMDMATH_F4_SIGN_H

#include <math.h>

#include "simdmath/private/vectors.h"

static inline vec_float4 _fabsf4(vec_float4 x) { return sm_fabs(x); }
static inline vec_float4 _negatef4(vec_float4 x) { return sm_fneg(x); }
static inline vec_float4 _copysignf4(vec_float4 x, vec_float4 y) { return sm_fsigned(sm_fabs(x), sm_fsign(y)); }

static inline vec_uint4 _signbitf4(vec_float4 x) { return (vec_uint4)((vec_int4)x >> 31); }
static inline vec_uint4 _isnanf4(vec_float4 x) { return sm_fis_nan(x); }
static inline vec_uint4 _isinff4(vec_float4 x) { return sm_fis_special(x) & ~sm_fis_nan(x); }
static inline vec_uint4 _isfinitef4(vec_float4 x) { return ~sm_fis_special(x); }
static inline vec_uint4 _is0denormf4(vec_float4 x) { return sm_ueq((vec_uint4)x & SM_F_EXPONENT, SM_U4(0)); }
static inline vec_uint4 _isnormalf4(vec_float4 x) { return ~(_is0denormf4(x) | sm_fis_special(x)); }

static inline vec_int4 _fpclassifyf4(vec_float4 x) {
  const vec_uint4 zero = sm_ueq((vec_uint4)x & SM_F_MAGNITUDE, SM_U4(0));
  vec_uint4 kind = sm_usel(SM_U4(FP_NORMAL), SM_U4(FP_SUBNORMAL), _is0denormf4(x));
  kind = sm_usel(kind, SM_U4(FP_ZERO), zero);
  kind = sm_usel(kind, SM_U4(FP_INFINITE), sm_fis_special(x));
  return (vec_int4)sm_usel(kind, SM_U4(FP_NAN), sm_fis_nan(x));
}

#endif
