/* The vector types and results of the SIMD math library, on the SPU and on the PPU. */
#ifndef SPU_EMU_SIMDMATH_TYPES_H
#define SPU_EMU_SIMDMATH_TYPES_H

#if defined(__SPU__)
#include <spu_intrinsics.h>
#include <vec_types.h>
#elif defined(__ALTIVEC__)
#include <altivec.h>
#include <vec_types.h>
#else
#error "simdmath.h is for SPU programs, and for PPU programs compiled with -maltivec (ppu-gcc does that)"
#endif

#define SM_INLINE static inline __attribute__((always_inline, unused))

typedef struct divi4_s {
  vec_int4 quot;
  vec_int4 rem;
} divi4_t;

typedef struct divu4_s {
  vec_uint4 quot;
  vec_uint4 rem;
} divu4_t;

typedef struct lldivi2_s {
  vec_llong2 quot;
  vec_llong2 rem;
} lldivi2_t;

typedef struct lldivu2_s {
  vec_ullong2 quot;
  vec_ullong2 rem;
} lldivu2_t;

/* Elements 0 and 1, then 2 and 3. */
typedef struct llroundf4_s {
  vec_llong2 vll[2];
} llroundf4_t;

/* Vectors of 64-bit integers and their elements. The PPU knows them by name only: there they go through
 * memory. */
#ifdef __SPU__
SM_INLINE vec_llong2 sm_ll2(long long a, long long b) {
  return (vec_llong2){a, b};
}
SM_INLINE vec_ullong2 sm_ull2(unsigned long long a, unsigned long long b) {
  return (vec_ullong2){a, b};
}
SM_INLINE long long sm_llat(vec_llong2 x, int i) {
  return x[i];
}
SM_INLINE unsigned long long sm_ullat(vec_ullong2 x, int i) {
  return x[i];
}
#else
typedef union sm_longs {
  vec_llong2 all;
  long long element[2];
} sm_longs;
SM_INLINE vec_llong2 sm_ll2(long long a, long long b) {
  sm_longs longs;
  longs.element[0] = a;
  longs.element[1] = b;
  return longs.all;
}
SM_INLINE vec_ullong2 sm_ull2(unsigned long long a, unsigned long long b) {
  return (vec_ullong2)sm_ll2((long long)a, (long long)b);
}
SM_INLINE long long sm_llat(vec_llong2 x, int i) {
  sm_longs longs;
  longs.all = x;
  return longs.element[i];
}
SM_INLINE unsigned long long sm_ullat(vec_ullong2 x, int i) {
  return (unsigned long long)sm_llat((vec_llong2)x, i);
}
#endif

#endif
