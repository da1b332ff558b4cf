/* Memory at multiples of 2^log2_align. A block is given back by free_align and by nothing else. */
#ifndef SPU_EMU_MISC_MEMORY_H
#define SPU_EMU_MISC_MEMORY_H

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Before the block lie the address that malloc gave and the block's size. */
typedef struct misc_block {
  void* start;
  size_t size;
} misc_block;

static inline misc_block* misc_block_of(void* memory) { return (misc_block*)memory - 1; }

/* Null without memory, and for an alignment that no address has. */
static inline void* malloc_align(size_t size, unsigned int log2_align) {
  size_t align, extra, address;
  char* start;
  void* memory;
  if (log2_align >= sizeof(size_t) * 8 - 1) return NULL;
  align = (size_t)1 << log2_align;
  if (align < sizeof(misc_block)) align = sizeof(misc_block);
  extra = align + sizeof(misc_block);
  if (size > (size_t)-1 - extra) return NULL;
  start = (char*)malloc(size + extra);
  if (start == NULL) return NULL;
  address = ((size_t)start + extra) & ~(align - 1);
  memory = start + (address - (size_t)start);
  misc_block_of(memory)->start = start;
  misc_block_of(memory)->size = size;
  return memory;
}

static inline void free_align(void* memory) {
  if (memory != NULL) free(misc_block_of(memory)->start);
}

static inline void* calloc_align(size_t count, size_t size, unsigned int log2_align) {
  void* memory;
  if (size != 0 && count > (size_t)-1 / size) return NULL;
  memory = malloc_align(count * size, log2_align);
  if (memory != NULL) memset(memory, 0, count * size);
  return memory;
}

/* Null, the old block unchanged, without memory; a size of 0 gives the block back. */
static inline void* realloc_align(void* old, size_t size, unsigned int log2_align) {
  void* memory;
  if (old != NULL && size == 0) {
    free_align(old);
    return NULL;
  }
  memory = malloc_align(size, log2_align);
  if (memory != NULL && old != NULL) {
    const size_t old_size = misc_block_of(old)->size;
    memcpy(memory, old, old_size < size ? old_size : size);
    free_align(old);
  }
  return memory;
}

#ifndef __SPU__
static inline void* malloc_huge(size_t size) { return malloc_align(size, 7); }
static inline void* calloc_huge(size_t count, size_t size) { return calloc_align(count, size, 7); }
static inline void* realloc_huge(void* old, size_t size) { return realloc_align(old, size, 7); }
static inline void free_huge(void* memory) { free_align(memory); }

#endif

#endif
