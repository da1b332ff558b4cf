#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t reader;
unsigned int table[32] __attribute__((aligned(128)));
unsigned int total[4] __attribute__((aligned(16)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY, i;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < 32; i++) table[i] = i * i;
  if (spe == NULL || spe_program_load(spe, &reader) != 0) return 1;
  if (spe_context_run(spe, &entry, 0, table, NULL, &stop) != 0) return 2;
  printf("%u, the address was %s\n", total[0], stop.result.spe_exit_code == 0 ? "right" : "wrong");
  return spe_context_destroy(spe);
}
