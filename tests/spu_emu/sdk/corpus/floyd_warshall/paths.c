#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t paths_spu;
static int length[NODES][NODES] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &paths_spu) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main() {
  int i, j, sum = 0, longest = 0;
  for (i = 0; i < NODES; i++) {
    for (j = 0; j < NODES; j++) length[i][j] = i == j ? 0 : 1000000;
    length[i][(i * 5 + 1) % NODES] = i == (i * 5 + 1) % NODES ? 0 : i % 7 + 1;
    length[i][(i + 1) % NODES] = i % 3 + 5;
  }
  if (run(length, NULL)) return 1;
  for (i = 0; i < NODES; i++) {
    for (j = 0; j < NODES; j++) sum += length[i][j], longest = length[i][j] > longest ? length[i][j] : longest;
  }
  printf("0 to 31: %d, longest %d, sum %d\n", length[0][31], longest, sum);
  return 0;
}
