#include <libspe2.h>
#include <stdio.h>

#define COUNT 256

extern spe_program_handle_t phases_spu;
static unsigned int values[COUNT] __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY, i, ordered = 1;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < COUNT; i++) values[i] = (i * 167 + 1) % 257;
  if (!spe || spe_program_load(spe, &phases_spu) != 0) return 1;
  if (spe_context_run(spe, &entry, 0, values, NULL, &stop) != 0) return 1;
  for (i = 1; i < COUNT; i++) ordered = ordered && values[i - 1] <= values[i];
  printf("%s, least %u, largest %u, %d rounds\n", ordered ? "sorted" : "NOT SORTED", values[0], values[COUNT - 1],
         stop.result.spe_exit_code);
  return 0;
}
