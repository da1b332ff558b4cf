/* Limits, extremes, unaligned vectors and random numbers, four at a time. */
#ifndef SPU_EMU_MISC_VECTORS_H
#define SPU_EMU_MISC_VECTORS_H

#include <string.h>

#include "simdmath/private/vectors.h"

static inline vec_float4 clamp_v(vec_float4 x, vec_float4 least, vec_float4 most) {
  return sm_fsel(sm_fsel(x, least, sm_fgt(least, x)), most, sm_fgt(x, most));
}
static inline vec_float4 clamp_0_to_1_v(vec_float4 x) { return clamp_v(x, SM_F4(0.0f), SM_F4(1.0f)); }
static inline vec_float4 clamp_minus1_to_1_v(vec_float4 x) { return clamp_v(x, SM_F4(-1.0f), SM_F4(1.0f)); }

static inline vec_float4 max_float_v(vec_float4 a, vec_float4 b) { return sm_fsel(a, b, sm_fgt(b, a)); }
static inline vec_float4 min_float_v(vec_float4 a, vec_float4 b) { return sm_fsel(a, b, sm_fgt(a, b)); }
static inline vec_int4 max_int_v(vec_int4 a, vec_int4 b) {
  return (vec_int4)sm_usel((vec_uint4)a, (vec_uint4)b, sm_igt(b, a));
}
static inline vec_int4 min_int_v(vec_int4 a, vec_int4 b) {
  return (vec_int4)sm_usel((vec_uint4)a, (vec_uint4)b, sm_igt(a, b));
}

/* Of the elements of one vector; those with a 3 look at the first three. */
static inline float misc_extreme(vec_float4 v, int count, int largest) {
  float element[4], result;
  int i;
  memcpy(element, &v, sizeof element);
  result = element[0];
  for (i = 1; i < count; ++i) {
    if (largest ? element[i] > result : element[i] < result) result = element[i];
  }
  return result;
}
static inline float max_vec_float4(vec_float4 v) { return misc_extreme(v, 4, 1); }
static inline float max_vec_float3(vec_float4 v) { return misc_extreme(v, 3, 1); }
static inline float min_vec_float4(vec_float4 v) { return misc_extreme(v, 4, 0); }
static inline float min_vec_float3(vec_float4 v) { return misc_extreme(v, 3, 0); }

static inline int misc_int_extreme(vec_int4 v, int count, int largest) {
  int element[4], result, i;
  memcpy(element, &v, sizeof element);
  result = element[0];
  for (i = 1; i < count; ++i) {
    if (largest ? element[i] > result : element[i] < result) result = element[i];
  }
  return result;
}
static inline int max_vec_int4(vec_int4 v) { return misc_int_extreme(v, 4, 1); }
static inline int max_vec_int3(vec_int4 v) { return misc_int_extreme(v, 3, 1); }
static inline int min_vec_int4(vec_int4 v) { return misc_int_extreme(v, 4, 0); }
static inline int min_vec_int3(vec_int4 v) { return misc_int_extreme(v, 3, 0); }

/* The 16 bytes at any address. */
static inline vec_uchar16 load_vec_unaligned(const unsigned char* address) {
  vec_uchar16 bytes;
  memcpy(&bytes, address, sizeof bytes);
  return bytes;
}
static inline void store_vec_unaligned(unsigned char* address, vec_uchar16 bytes) {
  memcpy(address, &bytes, sizeof bytes);
}

/* Four sequences of xorshift (Marsaglia, 13 17 5), from 1 to 2^32 - 1; rand_v leaves the sign away as rand() does. */
static inline vec_uint4* misc_random_state(void) {
  static vec_uint4 state = {0x2545f491u, 0x9e3779b9u, 0x85ebca6bu, 0xc2b2ae35u};
  return &state;
}
/* A seed of 0 is taken for 1. */
static inline void srand_v(vec_uint4 seed) {
  *misc_random_state() = seed | (sm_ueq(seed, SM_U4(0)) & SM_U4(1));
}
static inline vec_uint4 misc_random_words(void) {
  vec_uint4 x = *misc_random_state();
  x ^= x << 13;
  x ^= x >> 17;
  x ^= x << 5;
  *misc_random_state() = x;
  return x;
}
static inline vec_int4 rand_v(void) { return (vec_int4)(misc_random_words() & SM_F_MAGNITUDE); }
/* From 0 to below 1, and from -1 to below 1. */
static inline vec_float4 rand_0_to_1_v(void) {
  return sm_fsub((vec_float4)((misc_random_words() >> 9) | SM_F_ONE), SM_F4(1.0f));
}
static inline vec_float4 rand_minus1_to_1_v(void) {
  return sm_fsub((vec_float4)((misc_random_words() >> 9) | SM_U4(0x40000000u)), SM_F4(3.0f));
}

#endif
