#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t double_it, add_it;

static void *run(void *spe) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_run(spe, &entry, 0, NULL, NULL, NULL);
  return NULL;
}

static unsigned int through(spe_context_ptr_t spe, unsigned int word) {
  spe_in_mbox_write(spe, &word, 1, SPE_MBOX_ALL_BLOCKING);
  while (spe_out_mbox_status(spe) == 0) {
  }
  spe_out_mbox_read(spe, &word, 1);
  return word;
}

int main(void) {
  spe_program_handle_t *programs[2] = {&double_it, &add_it};
  spe_context_ptr_t spes[2];
  pthread_t threads[2];
  unsigned int i, word = 1, none = 0;
  for (i = 0; i < 2; i++) {
    spes[i] = spe_context_create(0, NULL);
    spe_program_load(spes[i], programs[i]);
    pthread_create(&threads[i], NULL, run, spes[i]);
  }
  for (i = 0; i < 20; i++) word = through(spes[1], through(spes[0], word));
  for (i = 0; i < 2; i++) {
    spe_in_mbox_write(spes[i], &none, 1, SPE_MBOX_ALL_BLOCKING);
    pthread_join(threads[i], NULL);
  }
  printf("%u\n", word);
  return 0;
}
