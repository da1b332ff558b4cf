/* Aligned allocation in the local store by the SDK's name, which the C library does not have. */
#ifndef MALLOC_ALIGN_H
#define MALLOC_ALIGN_H

#include <malloc.h>

/* `size` bytes at a multiple of 2 to the power of `log2_align`, or null. Freed with _free_align. */
static inline void* _malloc_align(size_t size, unsigned int log2_align) {
  return log2_align < sizeof(size_t) * 8 ? memalign((size_t)1 << log2_align, size) : NULL;
}

#endif
