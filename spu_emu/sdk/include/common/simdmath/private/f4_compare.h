/* Compares, the greater and the smaller. */
#ifndef SPU_EMU_SIMDMATH_F4_COMPARE_H
#define SPU_EMU_SIMDMATH_F4_COMPARE_H

#include "simdmath/private/vectors.h"

static inline vec_uint4 _isequalf4(vec_float4 x, vec_float4 y) { return sm_feq(x, y); }
static inline vec_uint4 _isgreaterf4(vec_float4 x, vec_float4 y) { return sm_fgt(x, y); }
static inline vec_uint4 _isgreaterequalf4(vec_float4 x, vec_float4 y) { return sm_fgt(x, y) | sm_feq(x, y); }
static inline vec_uint4 _islessf4(vec_float4 x, vec_float4 y) { return sm_fgt(y, x); }
static inline vec_uint4 _islessequalf4(vec_float4 x, vec_float4 y) { return sm_fgt(y, x) | sm_feq(x, y); }
static inline vec_uint4 _islessgreaterf4(vec_float4 x, vec_float4 y) { return sm_fgt(x, y) | sm_fgt(y, x); }
static inline vec_uint4 _isunorderedf4(vec_float4 x, vec_float4 y) { return sm_fis_nan(x) | sm_fis_nan(y); }

static inline vec_float4 _fmaxf4(vec_float4 x, vec_float4 y) {
  return sm_fsel(x, y, sm_fgt(y, x) | sm_fis_nan(x));
}
static inline vec_float4 _fminf4(vec_float4 x, vec_float4 y) {
  return sm_fsel(x, y, sm_fgt(x, y) | sm_fis_nan(x));
}
static inline vec_float4 _fdimf4(vec_float4 x, vec_float4 y) {
  const vec_float4 difference = sm_fsub(x, y);
  return (vec_float4)((vec_uint4)difference & (sm_fgt(x, y) | sm_fis_nan(difference)));
}
static inline vec_float4 _fmaf4(vec_float4 x, vec_float4 y, vec_float4 z) { return sm_fmadd(x, y, z); }

#endif
