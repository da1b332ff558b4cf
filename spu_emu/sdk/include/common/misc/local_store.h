/* Copies of any size and alignment between the local store and main memory. They wait until they are done. */
#ifndef SPU_EMU_MISC_LOCAL_STORE_H
#define SPU_EMU_MISC_LOCAL_STORE_H

#include <spu_mfcio.h>
#include <stdint.h>
#include <string.h>

/* What one transfer may take from both addresses: 1, 2, 4, 8 bytes where the last four bits agree, or lines of 16. */
static inline uint32_t misc_transfer_size(uint64_t memory, uint32_t local, size_t rest) {
  uint32_t size = 1;
  if (((uint32_t)memory & 15u) != (local & 15u)) return 0;
  if (((uint32_t)memory & 15u) == 0 && rest >= 16) return rest > 16384 ? 16384 : (uint32_t)rest & ~15u;
  while (size < 8 && ((uint32_t)memory & size) == 0 && size * 2 <= rest) size *= 2;
  return size;
}

static inline void misc_transfer(uint64_t memory, uint32_t local, uint32_t size, int is_put) {
  const uint32_t mask = mfc_read_tag_mask();
  /* A tag that programs use last; what else they have under it is waited for, too. */
  if (is_put) {
    mfc_put((volatile void*)(uintptr_t)local, memory, size, 31, 0, 0);
  } else {
    mfc_get((volatile void*)(uintptr_t)local, memory, size, 31, 0, 0);
  }
  mfc_write_tag_mask(1u << 31);
  mfc_read_tag_status_all();
  mfc_write_tag_mask(mask);
}

/* Through a buffer where the addresses do not agree: its lines of memory come, and on a put go back. */
static inline void misc_copy_line(uint64_t memory, uint32_t local, uint32_t size, int is_put) {
  static unsigned char line[16] __attribute__((aligned(16)));
  const uint32_t offset = (uint32_t)memory & 15u;
  unsigned char* bytes = (unsigned char*)(uintptr_t)local;
  uint32_t i;
  if (is_put) {
    memcpy(line + offset, bytes, size);
    for (i = 0; i < size;) {
      const uint32_t part = misc_transfer_size(memory + i, (uint32_t)(uintptr_t)line + offset + i, size - i);
      misc_transfer(memory + i, (uint32_t)(uintptr_t)line + offset + i, part, 1);
      i += part;
    }
  } else {
    misc_transfer(memory - offset, (uint32_t)(uintptr_t)line, 16, 0);
    memcpy(bytes, line + offset, size);
  }
}

static inline size_t misc_copy(uint64_t memory, uint32_t local, size_t size, int is_put) {
  size_t done = 0;
  while (done < size) {
    const size_t rest = size - done;
    uint32_t part = misc_transfer_size(memory + done, local + (uint32_t)done, rest);
    if (part != 0) {
      misc_transfer(memory + done, local + (uint32_t)done, part, is_put);
    } else {
      part = 16u - ((uint32_t)(memory + done) & 15u);
      if (part > rest) part = (uint32_t)rest;
      misc_copy_line(memory + done, local + (uint32_t)done, part, is_put);
    }
    done += part;
  }
  return size;
}

static inline size_t copy_from_ls(uint64_t to, uint32_t from, size_t size) { return misc_copy(to, from, size, 1); }
static inline size_t copy_to_ls(uint32_t to, uint64_t from, size_t size) { return misc_copy(from, to, size, 0); }

#endif
