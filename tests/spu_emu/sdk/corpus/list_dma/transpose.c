#include <libspe2.h>
#include <stdio.h>

#include "transpose.h"

extern spe_program_handle_t transpose_spu;

static float from[N][N] __attribute__((aligned(128)));
static float to[N][N] __attribute__((aligned(128)));

int main(void) {
  struct matrices matrices = {(unsigned long long)from, (unsigned long long)to};
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  int wrong = 0;

  for (int i = 0; i < N * N; i++) from[i / N][i % N] = i;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_program_load(spe, &transpose_spu) || spe_context_run(spe, &entry, 0, &matrices, NULL, &stop)) return 1;
  for (int i = 0; i < N * N; i++) wrong += to[i % N][i / N] != from[i / N][i % N];
  printf("%d of %d wrong, %d stalls\n", wrong, N * N, stop.result.spe_exit_code);
  return spe_context_destroy(spe);
}
