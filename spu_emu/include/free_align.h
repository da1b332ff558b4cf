/* The counterpart of malloc_align.h. */
#ifndef SPU_EMU_FREE_ALIGN_H
#define SPU_EMU_FREE_ALIGN_H

#include <stdlib.h>

/* Frees a block of _malloc_align; null is allowed. */
static inline void _free_align(void* block) {
  free(block);
}

#endif
