/* In the C of old programs: one function from the library, one compiled in, the small libraries. Exit code 0
 * if all is right. */
#include <cosf4.h>
#include <libmisc.h>
#include <massv.h>
#include <simdmath.h>
#include <simdmath/divi4.h>
#include <vec_literal.h>

typedef union {
  vec_float4 v;
  float f[4];
} floats;
typedef union {
  vec_int4 v;
  int i[4];
} ints;

int main(void) {
  floats root, cosine;
  ints quotient;
  float in[3] = {4.0f, 9.0f, 16.0f}, out[3];
  int count = 3;
  void* block = malloc_align(64, 7);
  root.v = sqrtf4(VEC_SPLAT_F32(16.0f));
  cosine.v = _cosf4(VEC_SPLAT_F32(0.0f));
  quotient.v = _divi4(VEC_SPLAT_S32(17), VEC_SPLAT_S32(5)).quot;
  vssqrt(out, in, &count);
  if (block == 0 || ((size_t)block & 127) != 0) return 1;
  free_align(block);
  if (root.f[0] != 4.0f || cosine.f[3] != 1.0f || quotient.i[2] != 3) return 2;
  return out[0] != 2.0f || out[1] != 3.0f || out[2] != 4.0f ? 3 : 0;
}
