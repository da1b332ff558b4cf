#include <libspe2.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>

#include "ring.h"

extern spe_program_handle_t ring_spu;
static struct link links[MEMBERS];
static spe_context_ptr_t spes[MEMBERS];

static void *run(void *argument) {
  const int i = (int)(intptr_t)argument;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  if (spe_context_run(spes[i], &entry, 0, &links[i], NULL, NULL) < 0) perror("ring");
  return NULL;
}

int main(void) {
  pthread_t threads[MEMBERS];
  unsigned int go = 1;
  spe_gang_context_ptr_t gang = spe_gang_context_create(0);
  for (int i = 0; i < MEMBERS; i++) {
    spes[i] = spe_context_create(SPE_MAP_PS, gang);
    if (spes[i] == NULL || spe_program_load(spes[i], &ring_spu)) return 1;
  }
  for (int i = 0; i < MEMBERS; i++) {
    links[i].next = (uintptr_t)spe_ls_area_get(spes[(i + 1) % MEMBERS]);
    links[i].number = i;
    pthread_create(&threads[i], NULL, run, (void *)(intptr_t)i);
  }
  for (int i = 0; i < MEMBERS; i++) spe_in_mbox_write(spes[i], &go, 1, SPE_MBOX_ALL_BLOCKING);
  for (int round = 0; round < ROUNDS; round++) {
    unsigned int token;
    while (spe_out_mbox_read(spes[0], &token, 1) == 0) {
    }
    printf("round %d: %u\n", round + 1, token);
  }
  for (int i = 0; i < MEMBERS; i++) pthread_join(threads[i], NULL);
  for (int i = 0; i < MEMBERS; i++) spe_context_destroy(spes[i]);
  return spe_gang_context_destroy(gang);
}
