#include "vec3.h"

vec_float4 vec3_cross(vec_float4 a, vec_float4 b) {
  const vec_uchar16 yzx = {4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 12, 13, 14, 15};
  const vec_float4 a1 = spu_shuffle(a, a, yzx), b1 = spu_shuffle(b, b, yzx);
  return spu_shuffle(spu_msub(a, b1, spu_mul(a1, b)), a, yzx);
}
