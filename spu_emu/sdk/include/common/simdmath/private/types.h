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

#ifdef __SPU__

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

#endif

#endif
