/* Pseudo-random numbers, by the C library's rand(). */
#ifndef SPU_EMU_MISC_RANDOM_H
#define SPU_EMU_MISC_RANDOM_H

#include <stdlib.h>

/* 24 bits of rand(), whatever its range. */
static inline unsigned int misc_random_bits(void) {
  return ((unsigned int)rand() << 12 ^ (unsigned int)rand()) & 0xffffffu;
}
/* From 0 to below 1. */
static inline float rand_0_to_1(void) { return (float)misc_random_bits() * (1.0f / 16777216.0f); }
/* From -1 to below 1. */
static inline float rand_minus1_to_1(void) { return (float)misc_random_bits() * (1.0f / 8388608.0f) - 1.0f; }

#endif
