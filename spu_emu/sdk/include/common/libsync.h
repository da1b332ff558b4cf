/* The SDK's synchronisation library: counters, mutexes, conditions, completions and reader-writer locks that SPEs and the
 * PPU share. Each is one word of main memory at a multiple of 4 and begins as zero; two of them in one line of 128 bytes
 * make each other wait. All functions are in headers; -lsync is not needed.
 *
 * On the SPU the names *_ea_t are effective addresses, on the PPU pointers. */
#ifndef SPU_EMU_LIBSYNC_H
#define SPU_EMU_LIBSYNC_H

#include "sync/atomic.h"
#include "sync/completion.h"
#include "sync/cond.h"
#include "sync/mutex.h"
#include "sync/rwlock.h"

#endif
