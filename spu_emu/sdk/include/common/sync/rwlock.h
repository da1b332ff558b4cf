/* Locks that many may hold to read, or one to write: the number of readers, or -1. */
#ifndef SPU_EMU_SYNC_RWLOCK_H
#define SPU_EMU_SYNC_RWLOCK_H

#include "sync/atomic.h"

typedef eaddr_t rwlock_ea_t;

static inline int read_trylock(rwlock_ea_t lock) {
  for (;;) {
    const int readers = sync_read(lock);
    if (readers < 0) return 0;
    if (sync_change(lock, readers, readers + 1)) return 1;
  }
}
static inline void read_lock(rwlock_ea_t lock) {
  while (!read_trylock(lock)) sync_pause();
}
static inline void read_unlock(rwlock_ea_t lock) { atomic_dec(lock); }
static inline int write_trylock(rwlock_ea_t lock) {
  while (sync_read(lock) == 0) {
    if (sync_change(lock, 0, -1)) return 1;
  }
  return 0;
}
static inline void write_lock(rwlock_ea_t lock) { sync_wait_to_change(lock, 0, -1); }
static inline void write_unlock(rwlock_ea_t lock) { atomic_set(lock, 0); }

#endif
