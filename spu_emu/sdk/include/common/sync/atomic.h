/* Counters. */
#ifndef SPU_EMU_SYNC_ATOMIC_H
#define SPU_EMU_SYNC_ATOMIC_H

#include "sync/word.h"

typedef eaddr_t atomic_ea_t;

static inline int atomic_read(atomic_ea_t v) { return sync_read(v); }

/* Both give the value before. */
static inline int sync_exchange(atomic_ea_t v, int value) {
  int old = sync_read(v);
  while (!sync_change(v, old, value)) old = sync_read(v);
  return old;
}
static inline int sync_fetch_add(atomic_ea_t v, int a) {
  int old = sync_read(v);
  while (!sync_change(v, old, (int)((unsigned int)old + (unsigned int)a))) old = sync_read(v);
  return old;
}

static inline void atomic_set(atomic_ea_t v, int value) { (void)sync_exchange(v, value); }
static inline int atomic_add_return(int a, atomic_ea_t v) { return (int)((unsigned int)sync_fetch_add(v, a) + (unsigned int)a); }
static inline int atomic_sub_return(int a, atomic_ea_t v) { return atomic_add_return(-a, v); }
static inline int atomic_inc_return(atomic_ea_t v) { return atomic_add_return(1, v); }
static inline int atomic_dec_return(atomic_ea_t v) { return atomic_add_return(-1, v); }
static inline void atomic_add(int a, atomic_ea_t v) { (void)sync_fetch_add(v, a); }
static inline void atomic_sub(int a, atomic_ea_t v) { (void)sync_fetch_add(v, -a); }
static inline void atomic_inc(atomic_ea_t v) { (void)sync_fetch_add(v, 1); }
static inline void atomic_dec(atomic_ea_t v) { (void)sync_fetch_add(v, -1); }

/* Whether the counter is zero then. */
static inline int atomic_sub_and_test(int a, atomic_ea_t v) { return atomic_sub_return(a, v) == 0; }
static inline int atomic_dec_and_test(atomic_ea_t v) { return atomic_dec_return(v) == 0; }

/* The value less one, which is stored unless it is negative. */
static inline int atomic_dec_if_positive(atomic_ea_t v) {
  int old = sync_read(v);
  while (old > 0 && !sync_change(v, old, old - 1)) old = sync_read(v);
  return old - 1;
}

#endif
