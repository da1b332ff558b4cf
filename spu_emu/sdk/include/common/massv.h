/* Mathematical functions of whole arrays, by the names of the MASS library: vssin(y, x, &n) is y[i] = sin(x[i]) for n
 * floats, by the functions of simdmath.h and with their errors. All functions are in headers; -lmassv is not needed.
 *
 * Arrays may have any alignment and length, and y may be x. The names with vs are for floats; those with v alone are for
 * doubles, on the SPU only. */
#ifndef SPU_EMU_MASSV_H
#define SPU_EMU_MASSV_H

#include <simdmath.h>
#include <string.h>

/* Of the last call what there is of elements; the others are 1, which every function takes. */
#define MASSV_EACH(type, vector_type, lanes, ...)           \
  int i, j;                                                       \
  for (i = 0; i < *n; i += (lanes)) {                             \
    const int part = *n - i < (lanes) ? *n - i : (lanes);         \
    type first[lanes], second[lanes];                             \
    vector_type a, b;                                             \
    for (j = 0; j < (lanes); ++j) first[j] = second[j] = (type)1; \
    __VA_ARGS__                                                   \
  }

#define MASSV_FLOATS(name, function)                                       \
  static inline void name(float* y, const float* x, const int* n) {        \
    MASSV_EACH(float, vec_float4, 4, {                                     \
      memcpy(first, x + i, (unsigned int)part * sizeof *x);                \
      memcpy(&a, first, sizeof a);                                         \
      b = function(a);                                                     \
      memcpy(y + i, &b, (unsigned int)part * sizeof *y);                   \
    })                                                                     \
  }
#define MASSV_FLOATS_OF_TWO(name, function)                                           \
  static inline void name(float* z, const float* x, const float* y, const int* n) {  \
    MASSV_EACH(float, vec_float4, 4, {                                                \
      memcpy(first, x + i, (unsigned int)part * sizeof *x);                           \
      memcpy(second, y + i, (unsigned int)part * sizeof *y);                          \
      memcpy(&a, first, sizeof a);                                                    \
      memcpy(&b, second, sizeof b);                                                   \
      b = function(a, b);                                                             \
      memcpy(z + i, &b, (unsigned int)part * sizeof *z);                              \
    })                                                                                \
  }

MASSV_FLOATS(vsacos, acosf4)
MASSV_FLOATS(vsacosh, acoshf4)
MASSV_FLOATS(vsasin, asinf4)
MASSV_FLOATS(vsasinh, asinhf4)
MASSV_FLOATS(vsatanh, atanhf4)
MASSV_FLOATS(vscbrt, cbrtf4)
MASSV_FLOATS(vscos, cosf4)
MASSV_FLOATS(vscosh, coshf4)
MASSV_FLOATS(vsexp, expf4)
MASSV_FLOATS(vsexpm1, expm1f4)
MASSV_FLOATS(vsint, truncf4)
MASSV_FLOATS(vsnint, roundf4)
MASSV_FLOATS(vslog, logf4)
MASSV_FLOATS(vslog10, log10f4)
MASSV_FLOATS(vslog1p, log1pf4)
MASSV_FLOATS(vsrec, recipf4)
MASSV_FLOATS(vsrsqrt, rsqrtf4)
MASSV_FLOATS(vssin, sinf4)
MASSV_FLOATS(vssinh, sinhf4)
MASSV_FLOATS(vssqrt, sqrtf4)
MASSV_FLOATS(vstan, tanf4)
MASSV_FLOATS(vstanh, tanhf4)
MASSV_FLOATS_OF_TWO(vsatan2, atan2f4)
MASSV_FLOATS_OF_TWO(vsdiv, divf4)
MASSV_FLOATS_OF_TWO(vspow, powf4)

static inline void vssincos(float* s, float* c, const float* x, const int* n) {
  MASSV_EACH(float, vec_float4, 4, {
    memcpy(first, x + i, (unsigned int)part * sizeof *x);
    memcpy(&a, first, sizeof a);
    sincosf4(a, &a, &b);
    memcpy(s + i, &a, (unsigned int)part * sizeof *s);
    memcpy(c + i, &b, (unsigned int)part * sizeof *c);
  })
}

#ifdef __SPU__

#define MASSV_DOUBLES(name, function)                                  \
  static inline void name(double* y, const double* x, const int* n) {  \
    MASSV_EACH(double, vec_double2, 2, {                               \
      memcpy(first, x + i, (unsigned int)part * sizeof *x);            \
      memcpy(&a, first, sizeof a);                                     \
      b = function(a);                                                 \
      memcpy(y + i, &b, (unsigned int)part * sizeof *y);               \
    })                                                                 \
  }
#define MASSV_DOUBLES_OF_TWO(name, function)                                             \
  static inline void name(double* z, const double* x, const double* y, const int* n) {  \
    MASSV_EACH(double, vec_double2, 2, {                                                 \
      memcpy(first, x + i, (unsigned int)part * sizeof *x);                              \
      memcpy(second, y + i, (unsigned int)part * sizeof *y);                             \
      memcpy(&a, first, sizeof a);                                                       \
      memcpy(&b, second, sizeof b);                                                      \
      b = function(a, b);                                                                \
      memcpy(z + i, &b, (unsigned int)part * sizeof *z);                                 \
    })                                                                                   \
  }

MASSV_DOUBLES(vacos, acosd2)
MASSV_DOUBLES(vacosh, acoshd2)
MASSV_DOUBLES(vasin, asind2)
MASSV_DOUBLES(vasinh, asinhd2)
MASSV_DOUBLES(vatanh, atanhd2)
MASSV_DOUBLES(vcbrt, cbrtd2)
MASSV_DOUBLES(vcos, cosd2)
MASSV_DOUBLES(vcosh, coshd2)
MASSV_DOUBLES(vexp, expd2)
MASSV_DOUBLES(vexpm1, expm1d2)
MASSV_DOUBLES(vdint, truncd2)
MASSV_DOUBLES(vdnint, roundd2)
MASSV_DOUBLES(vlog, logd2)
MASSV_DOUBLES(vlog10, log10d2)
MASSV_DOUBLES(vlog1p, log1pd2)
MASSV_DOUBLES(vrec, recipd2)
MASSV_DOUBLES(vrsqrt, rsqrtd2)
MASSV_DOUBLES(vsin, sind2)
MASSV_DOUBLES(vsinh, sinhd2)
MASSV_DOUBLES(vsqrt, sqrtd2)
MASSV_DOUBLES(vtan, tand2)
MASSV_DOUBLES(vtanh, tanhd2)
MASSV_DOUBLES_OF_TWO(vatan2, atan2d2)
MASSV_DOUBLES_OF_TWO(vdiv, divd2)
MASSV_DOUBLES_OF_TWO(vpow, powd2)

static inline void vsincos(double* s, double* c, const double* x, const int* n) {
  MASSV_EACH(double, vec_double2, 2, {
    memcpy(first, x + i, (unsigned int)part * sizeof *x);
    memcpy(&a, first, sizeof a);
    sincosd2(a, &a, &b);
    memcpy(s + i, &a, (unsigned int)part * sizeof *s);
    memcpy(c + i, &b, (unsigned int)part * sizeof *c);
  })
}

#undef MASSV_DOUBLES
#undef MASSV_DOUBLES_OF_TWO

#endif

#undef MASSV_EACH
#undef MASSV_FLOATS
#undef MASSV_FLOATS_OF_TWO

#endif
