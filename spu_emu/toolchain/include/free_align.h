/* The counterpart of malloc_align.h. */
#ifndef FREE_ALIGN_H
#define FREE_ALIGN_H

#include <stdlib.h>

/* Frees a block of _malloc_align; null is allowed. */
static inline void _free_align(void* block) {
  free(block);
}

#endif
