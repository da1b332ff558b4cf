#include "queue.h"

#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

#define WORKERS 5

extern spe_program_handle_t worker;

static queue_t queue __attribute__((aligned(128)));
static item_t items[ITEMS] __attribute__((aligned(128)));

static void *work(void *number) {
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  if (spe_program_load(spe, &worker) || spe_context_run(spe, &entry, 0, &queue, number, NULL)) perror("worker");
  spe_context_destroy(spe);
  return NULL;
}

int main() {
  pthread_t threads[WORKERS];
  unsigned int i, right = 0;
  queue.items = ITEMS;
  queue.item_ea = (unsigned int)items;
  for (i = 0; i < ITEMS; i++) items[i].number = i * 97 + 3;
  for (i = 0; i < WORKERS; i++) pthread_create(&threads[i], NULL, work, (void *)i);
  for (i = 0; i < WORKERS; i++) pthread_join(threads[i], NULL);
  for (i = 0; i < ITEMS; i++) right += items[i].by != 0 && (int)items[i].steps == collatz_steps(items[i].number);
  printf("%u of %u items are right\n", right, ITEMS);
  return 0;
}
