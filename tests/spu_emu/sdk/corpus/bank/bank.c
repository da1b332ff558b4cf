#include <libspe2.h>
#include <libsync.h>
#include <pthread.h>
#include <stdio.h>

#include "bank.h"

extern spe_program_handle_t teller;
static bank_t bank;

static void *run(void *seed) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_program_load(spe, &teller) || spe_context_run(spe, &entry, 0, &bank, seed, NULL)) perror("teller");
  spe_context_destroy(spe);
  return NULL;
}

int main(void) {
  pthread_t threads[TELLERS];
  long i;
  int sum = 0;
  mutex_init((mutex_ea_t)&bank.mutex);
  init_completion((completion_ea_t)&bank.done);
  for (i = 0; i < ACCOUNTS; i++) bank.balance[i] = 1000;
  for (i = 0; i < TELLERS; i++) pthread_create(&threads[i], NULL, run, (void *)(i + 1));
  for (i = 0; i < 50; i++) { /* the host takes part */
    mutex_lock((mutex_ea_t)&bank.mutex);
    bank.balance[0] += 7;
    bank.balance[15] -= 7;
    mutex_unlock((mutex_ea_t)&bank.mutex);
  }
  for (i = 0; i < TELLERS; i++) wait_for_completion((completion_ea_t)&bank.done);
  for (i = 0; i < TELLERS; i++) pthread_join(threads[i], NULL);
  for (i = 0; i < ACCOUNTS; i++) printf("%d%c", bank.balance[i], i % 8 == 7 ? '\n' : ' '), sum += bank.balance[i];
  printf("%d transfers, together %d\n", atomic_read((atomic_ea_t)&bank.total), sum);
  return 0;
}
