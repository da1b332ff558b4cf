#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t volumes;
static float edges[20][3][4] __attribute__((aligned(128)));
static float volume[20] __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  int i, j;
  float sum = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < 20; i++) {
    for (j = 0; j < 9; j++) edges[i][j / 3][j % 3] = (i * 7 + j * j * 5) % 11 - 5;
  }
  spe_program_load(spe, &volumes);
  if (spe_context_run(spe, &entry, 0, edges, volume, NULL)) return 1;
  for (i = 0; i < 20; i++) sum += volume[i];
  printf("%g %g %g, sum %g\n", volume[0], volume[1], volume[19], sum);
  return 0;
}
