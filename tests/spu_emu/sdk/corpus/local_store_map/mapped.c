#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

extern spe_program_handle_t board;
static spe_context_ptr_t spe;

static void *run(void *unused) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  if (spe_context_run(spe, &entry, 0, NULL, NULL, NULL)) perror("run");
  return unused;
}

int main(void) {
  volatile unsigned int *words;
  unsigned int where, round, i;
  pthread_t thread;
  spe = spe_context_create(SPE_MAP_PS, NULL);
  spe_program_load(spe, &board);
  printf("%d bytes of local store\n", spe_ls_size_get(spe));
  pthread_create(&thread, NULL, run, NULL);
  while (spe_out_mbox_read(spe, &where, 1) != 1) {
  }
  words = (unsigned int *)((char *)spe_ls_area_get(spe) + where);
  for (round = 1; round <= 3; round++) {
    for (i = 1; i <= 30; i++) words[i] = round * 100 + i;
    __sync_synchronize();
    words[0] = 2 * round - 1;
    while (words[0] != 2 * round) {
    }
    __sync_synchronize();
    printf("round %u: %u\n", round, words[31]);
  }
  pthread_join(thread, NULL);
  return spe_context_destroy(spe);
}
