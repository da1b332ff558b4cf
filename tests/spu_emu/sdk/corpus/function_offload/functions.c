#include <spu_intrinsics.h>

float dot(vec_float4 *a, vec_float4 *b, unsigned int quadwords) {
  vec_float4 sum = spu_splats(0.0f);
  unsigned int i;
  for (i = 0; i < quadwords; i++) sum = spu_madd(a[i], b[i], sum);
  sum = spu_add(sum, spu_rlqwbyte(sum, 8));
  sum = spu_add(sum, spu_rlqwbyte(sum, 4));
  return spu_extract(sum, 0);
}

float polynomial(float x, vec_float4 *coefficients, unsigned int quadwords) {
  float value = 0;
  unsigned int i, k;
  for (i = quadwords; i-- > 0;) {
    for (k = 4; k-- > 0;) value = value * x + ((float *)&coefficients[i])[k];
  }
  return value;
}
