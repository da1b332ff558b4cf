/* Vectors of three floats, each in a register. */
#include <spu_intrinsics.h>

float vec3_dot(vec_float4 a, vec_float4 b);
vec_float4 vec3_cross(vec_float4 a, vec_float4 b);
