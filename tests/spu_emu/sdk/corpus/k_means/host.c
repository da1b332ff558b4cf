#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t nearest;
static float block[68][4] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &nearest) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  int i, rounds;
  for (i = 0; i < 64; i++) {
    block[4 + i][0] = i % 2 * 40 + i * 7 % 11;
    block[4 + i][1] = i / 2 % 2 * 30 + i * 5 % 7;
  }
  for (i = 0; i < 4; i++) block[i][0] = block[4 + i * 3][0], block[i][1] = block[4 + i * 3][1];
  rounds = run(block, (void *)20);
  printf("%s\n", rounds > 1 && rounds < 20 ? "came to rest" : "RESTLESS");
  for (i = 0; i < 4; i++) printf("%.2f %.2f: %g points\n", block[i][0], block[i][1], block[i][3]);
  return 0;
}
