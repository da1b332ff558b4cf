/* Completions: how many that wait may go on. */
#ifndef SPU_EMU_SYNC_COMPLETION_H
#define SPU_EMU_SYNC_COMPLETION_H

#include "sync/atomic.h"

typedef eaddr_t completion_ea_t;

enum { sync_all_complete = 0x40000000 };

static inline void init_completion(completion_ea_t completion) { atomic_set(completion, 0); }
static inline void complete(completion_ea_t completion) { atomic_inc(completion); }
/* For all that wait, now and later. */
static inline void complete_all(completion_ea_t completion) { atomic_set(completion, sync_all_complete); }
static inline void wait_for_completion(completion_ea_t completion) {
  for (;;) {
    const int old = sync_read(completion);
    if (old >= sync_all_complete || (old > 0 && sync_change(completion, old, old - 1))) return;
    sync_pause();
  }
}

#endif
