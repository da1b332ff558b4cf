/* Conditions. In the word's upper half is how many have begun to wait, in the lower one how many of these may go on. */
#ifndef SPU_EMU_SYNC_COND_H
#define SPU_EMU_SYNC_COND_H

#include "sync/mutex.h"

typedef eaddr_t cond_ea_t;

static inline void cond_init(cond_ea_t cond) { atomic_set(cond, 0); }

/* Gives the mutex back while it waits; up to 32,767 may wait. */
static inline void cond_wait(cond_ea_t cond, mutex_ea_t mutex) {
  const unsigned int ticket = (unsigned int)sync_fetch_add(cond, 0x10000) >> 16;
  mutex_unlock(mutex);
  while ((((unsigned int)sync_read(cond) - ticket - 1u) & 0x8000u) != 0) sync_pause();
  mutex_lock(mutex);
}

static inline void sync_release(cond_ea_t cond, unsigned int at_most) {
  for (;;) {
    const unsigned int old = (unsigned int)sync_read(cond);
    const unsigned int waiting = ((old >> 16) - old) & 0xffffu;
    const unsigned int released = waiting < at_most ? waiting : at_most;
    const unsigned int fresh = (old & 0xffff0000u) | ((old + released) & 0xffffu);
    if (sync_change(cond, (int)old, (int)fresh)) return;
  }
}
static inline void cond_signal(cond_ea_t cond) { sync_release(cond, 1); }
static inline void cond_broadcast(cond_ea_t cond) { sync_release(cond, 0xffffu); }

#endif
