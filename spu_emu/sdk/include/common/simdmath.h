/* The SIMD math library: the functions of <math.h> on vectors, with the SDK's names. For C and C++.
 *
 * Errors and special values of every function are in docs/simdmath.md. Link with -lsimdmath; in an SPU program that is
 * compiled for the host engine nothing has to be linked. The functions themselves, to be compiled into a program, are
 * _sinf4 in <sinf4.h> and so on. */
#ifndef SPU_EMU_SIMDMATH_H
#define SPU_EMU_SIMDMATH_H

#include "simdmath/private/types.h"

#define SM_E 2.7182818284590452354
#define SM_LOG2E 1.4426950408889634074
#define SM_LOG10E 0.43429448190325182765
#define SM_LN2 0.69314718055994530942
#define SM_LN10 2.30258509299404568402
#define SM_PI 3.14159265358979323846
#define SM_PI_2 1.57079632679489661923
#define SM_PI_4 0.78539816339744830962
#define SM_1_PI 0.31830988618379067154
#define SM_2_PI 0.63661977236758134308
#define SM_2_SQRTPI 1.12837916709551257390
#define SM_SQRT2 1.41421356237309504880
#define SM_SQRT1_2 0.70710678118654752440

#if defined(SPU_EMU_SPU_INTRINSICS_H) || defined(SIMDMATH_INLINE)
/* Compiled into the program: with the host engine's own intrinsics always, elsewhere where the macro asks for it. */
#include "simdmath/private/all.h"
#define SM_1(header, result, name, A) \
  static inline result name(A x) { return _##name(x); }
#define SM_2(header, result, name, A, B) \
  static inline result name(A x, B y) { return _##name(x, y); }
#define SM_3(header, result, name, A, B, C) \
  static inline result name(A x, B y, C z) { return _##name(x, y, z); }
#define SM_1P(header, result, name, A, P) \
  static inline result name(A x, P* p) { return _##name(x, p); }
#define SM_2P(header, result, name, A, B, P) \
  static inline result name(A x, B y, P* p) { return _##name(x, y, p); }
#define SM_PP(header, name, A) \
  static inline void name(A x, A* p, A* q) { _##name(x, p, q); }
#include "simdmath/functions.def"
#else
#ifdef __cplusplus
extern "C" {
#endif
#define SM_1(header, result, name, A) result name(A x);
#define SM_2(header, result, name, A, B) result name(A x, B y);
#define SM_3(header, result, name, A, B, C) result name(A x, B y, C z);
#define SM_1P(header, result, name, A, P) result name(A x, P* p);
#define SM_2P(header, result, name, A, B, P) result name(A x, B y, P* p);
#define SM_PP(header, name, A) void name(A x, A* p, A* q);
#include "simdmath/functions.def"
#ifdef __cplusplus
}
#endif
#endif

#undef SM_1
#undef SM_2
#undef SM_3
#undef SM_1P
#undef SM_2P
#undef SM_PP

#endif
