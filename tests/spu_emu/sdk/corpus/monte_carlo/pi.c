#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

#define SPES 6
#define ROUNDS 2000

extern spe_program_handle_t darts;

static void *throw_darts(void *seed) {
  unsigned int entry = SPE_DEFAULT_ENTRY, inside = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  spe_program_load(spe, &darts);
  spe_context_run(spe, &entry, 0, seed, (void *)ROUNDS, NULL);
  spe_out_mbox_read(spe, &inside, 1);
  spe_context_destroy(spe);
  return (void *)inside;
}

int main() {
  pthread_t threads[SPES];
  unsigned int i, sum = 0;
  void *inside;
  for (i = 0; i < SPES; i++) pthread_create(threads + i, NULL, throw_darts, (void *)(i + 1));
  for (i = 0; i < SPES; i++) {
    pthread_join(threads[i], &inside);
    printf("SPE %u: %u\n", i, (unsigned int)inside);
    sum += (unsigned int)inside;
  }
  printf("pi is about %.2f\n", 4.0 * sum / (SPES * ROUNDS * 4.0));
  return 0;
}
