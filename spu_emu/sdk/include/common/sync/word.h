/* The one thing that everything here stands on: a word of main memory that is changed as a whole or not at all. */
#ifndef SPU_EMU_SYNC_WORD_H
#define SPU_EMU_SYNC_WORD_H

#ifdef __SPU__

#include <spu_mfcio.h>

typedef unsigned long long eaddr_t;

/* The line with the word, as getllar brought it. The same for all: there is one thread, and a line is changed at once. */
static inline volatile int* sync_line(void) {
  static volatile int line[32] __attribute__((aligned(128)));
  return line;
}
static inline volatile int* sync_load(eaddr_t word) {
  volatile int* line = sync_line();
  mfc_getllar((volatile void*)line, word & ~127ull, 0, 0);
  (void)mfc_read_atomic_status();
  return line + (((unsigned int)word & 127u) >> 2);
}
static inline int sync_read(eaddr_t word) { return *sync_load(word); }

/* From the value that was read to another one; 0 when somebody else was faster. */
static inline int sync_change(eaddr_t word, int from, int to) {
  volatile int* value = sync_load(word);
  if (*value != from) return 0;
  *value = to;
  mfc_putllc((volatile void*)sync_line(), word & ~127ull, 0, 0);
  return (mfc_read_atomic_status() & MFC_PUTLLC_STATUS) == 0;
}
static inline void sync_pause(void) {}

#else

#include <sched.h>

typedef void* eaddr_t;

static inline int sync_read(eaddr_t word) { return __atomic_load_n((int*)word, __ATOMIC_SEQ_CST); }
static inline int sync_change(eaddr_t word, int from, int to) {
  return __atomic_compare_exchange_n((int*)word, &from, to, 0, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
}
static inline void sync_pause(void) { (void)sched_yield(); }

#endif

/* Waits until the word is what it shall be, then changes it. */
static inline void sync_wait_to_change(eaddr_t word, int from, int to) {
  while (!sync_change(word, from, to)) sync_pause();
}

#endif
