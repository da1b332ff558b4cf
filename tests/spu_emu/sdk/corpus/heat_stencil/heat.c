#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

#define SIDE 32
#define STRIPS 4

extern spe_program_handle_t strip;
static struct {
  float plates[2][SIDE][SIDE];
  unsigned int arrived[32];
} memory __attribute__((aligned(128)));

static void *run(void *number) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  spe_program_load(spe, &strip);
  if (spe_context_run(spe, &entry, 0, &memory, number, NULL)) perror("strip");
  spe_context_destroy(spe);
  return NULL;
}

int main(void) {
  pthread_t threads[STRIPS];
  long i;
  int j;
  float sum = 0;
  memory.plates[0][7][9] = 1024;
  memory.plates[0][31][0] = 512;
  for (i = 0; i < STRIPS; i++) pthread_create(&threads[i], NULL, run, (void *)i);
  for (i = 0; i < STRIPS; i++) pthread_join(threads[i], NULL);
  for (i = 0; i < SIDE; i++) {
    for (j = 0; j < SIDE; j++) sum += memory.plates[0][i][j];
  }
  printf("%.3f %.3f %.3f, all the heat: %.2f\n", memory.plates[0][7][9], memory.plates[0][8][9], memory.plates[0][0][0], sum);
  return 0;
}
