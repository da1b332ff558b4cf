#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t rays_spu;
static char image[32][32] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &rays_spu) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  if (run(image, NULL)) return 1;
  for (int i = 0; i < 32; i += 2) printf("%.32s|\n", image[i]);
  return 0;
}
