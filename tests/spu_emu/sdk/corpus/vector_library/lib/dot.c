#include "vec3.h"

float vec3_dot(vec_float4 a, vec_float4 b) {
  const vec_float4 product = spu_mul(a, b);
  return spu_extract(product, 0) + spu_extract(product, 1) + spu_extract(product, 2);
}
