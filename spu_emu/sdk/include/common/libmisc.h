/* The SDK's library of small things: aligned memory, pseudo-random numbers, limits, unaligned vectors, and on the SPU
 * copies between local stores and main memory. All functions are in headers; -lmisc is not needed.
 *
 * Vector functions are there where vectors are: on the SPU, and on the PPU with -maltivec. Memory on huge pages is plain
 * memory with the alignment asked for. */
#ifndef SPU_EMU_LIBMISC_H
#define SPU_EMU_LIBMISC_H

#include "misc/memory.h"
#include "misc/random.h"

#if defined(__SPU__) || defined(__ALTIVEC__)
#include "misc/vectors.h"
#endif
/* The host engine has no pointers for numbers that are local store addresses. */
#if defined(__SPU__) && !defined(SPU_EMU_SPU_INTRINSICS_H)
#include "misc/local_store.h"
#endif

static inline float clamp(float x, float least, float most) {
  return x < least ? least : x > most ? most : x;
}
static inline float clamp_0_to_1(float x) { return clamp(x, 0.0f, 1.0f); }
static inline float clamp_minus1_to_1(float x) { return clamp(x, -1.0f, 1.0f); }

#endif
