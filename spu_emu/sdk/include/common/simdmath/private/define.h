/* Turns a line of functions.def into the function of the library. */
#ifndef SPU_EMU_SIMDMATH_DEFINE_H
#define SPU_EMU_SIMDMATH_DEFINE_H

#include "simdmath.h"

#define SM_1(header, result, name, A) \
  result name(A x) { return _##name(x); }
#define SM_2(header, result, name, A, B) \
  result name(A x, B y) { return _##name(x, y); }
#define SM_3(header, result, name, A, B, C) \
  result name(A x, B y, C z) { return _##name(x, y, z); }
#define SM_1P(header, result, name, A, P) \
  result name(A x, P* p) { return _##name(x, p); }
#define SM_2P(header, result, name, A, B, P) \
  result name(A x, B y, P* p) { return _##name(x, y, p); }
#define SM_PP(header, name, A) \
  void name(A x, A* p, A* q) { _##name(x, p, q); }

#endif
