#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t longest;


static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &longest) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  long i;
  for (i = 1; i <= 81; i += 40) {
    if (run((void *)i, (void *)(i + 39))) return 1;
  }
  return 0;
}
