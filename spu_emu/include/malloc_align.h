/* Aligned allocation as the SDK offers it: from the local store in an SPU program, from the heap elsewhere.
 */
#ifndef SPU_EMU_MALLOC_ALIGN_H
#define SPU_EMU_MALLOC_ALIGN_H

#include <stddef.h>
#include <stdlib.h>

/* `size` bytes at a multiple of 2 to the power of `log2_align`, or null. Freed with _free_align. */
static inline void* _malloc_align(size_t size, unsigned int log2_align) {
  const size_t smallest = sizeof(void*);
  const size_t align = (size_t)1 << log2_align;
  void* block = NULL;
  if (log2_align >= sizeof(size_t) * 8) return NULL;
  return posix_memalign(&block, align < smallest ? smallest : align, size) == 0 ? block : NULL;
}

#endif
