#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t filter;
static unsigned char image[32][32] __attribute__((aligned(128)));
static unsigned char edges[32][32] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &filter) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  int i, j;
  unsigned int sum = 0, strong = 0;
  for (i = 0; i < 32; i++) {
    for (j = 0; j < 32; j++) image[i][j] = (i - 16) * (i - 16) + (j - 16) * (j - 16) < 100 ? 200 : i * 2;
  }
  if (run(image, edges)) return 1;
  for (i = 0; i < 32; i++) {
    for (j = 0; j < 32; j++) sum += edges[i][j], strong += edges[i][j] == 255;
  }
  printf("sum %u, %u strong, middle %u, (16, 25) %u\n", sum, strong, edges[16][16], edges[16][25]);
  return 0;
}
