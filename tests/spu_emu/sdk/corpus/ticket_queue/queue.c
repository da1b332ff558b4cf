#include <libspe2.h>
#include <libsync.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>

#include "queue.h"

extern spe_program_handle_t eater;
static volatile queue_t queue;

static void *eat(void *unused) {
  unsigned int entry = SPE_DEFAULT_ENTRY, sum = 0;
  (void)unused;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  spe_program_load(spe, &eater);
  spe_context_run(spe, &entry, 0, (void *)&queue, NULL, NULL);
  spe_out_mbox_read(spe, &sum, 1);
  spe_context_destroy(spe);
  return (void *)sum;
}

static void put(unsigned int item) {
  for (int done = 0; !done; sched_yield()) {
    mutex_lock((mutex_ea_t)&queue.lock);
    if (queue.tail - queue.head < PLACES) {
      queue.items[queue.tail % PLACES] = item;
      queue.tail++;
      done = 1;
    }
    mutex_unlock((mutex_ea_t)&queue.lock);
  }
}

int main(void) {
  pthread_t threads[EATERS];
  unsigned int sum = 0, right = 0;
  for (int i = 0; i < EATERS; i++) pthread_create(&threads[i], NULL, eat, NULL);
  for (unsigned int i = 1; i <= ITEMS; i++) put(i), right += i * i;
  put(0);
  for (int i = 0; i < EATERS; i++) {
    void *part;
    pthread_join(threads[i], &part);
    sum += (unsigned int)part;
  }
  printf("eaten %u of %u\n", sum, right);
  return sum != right;
}
