/* Mutexes: 0 free, 1 held. Who waits asks again and again. */
#ifndef SPU_EMU_SYNC_MUTEX_H
#define SPU_EMU_SYNC_MUTEX_H

#include "sync/atomic.h"

typedef eaddr_t mutex_ea_t;

static inline void mutex_init(mutex_ea_t lock) { atomic_set(lock, 0); }
static inline void mutex_lock(mutex_ea_t lock) { sync_wait_to_change(lock, 0, 1); }
/* 1 when it is held now. */
static inline int mutex_trylock(mutex_ea_t lock) {
  while (sync_read(lock) == 0) {
    if (sync_change(lock, 0, 1)) return 1;
  }
  return 0;
}
/* On the SPU transfers of the data that it guards must have been waited for. */
static inline void mutex_unlock(mutex_ea_t lock) {
  atomic_set(lock, 0);
}

#endif
