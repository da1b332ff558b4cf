#include <libspe2.h>
#include <stdio.h>
#include "record.h"
extern spe_program_handle_t spu_record;
static record_t record = {5, 0x0f0, 1000, {1.5f}, {1, 2, 3, -4}, 1.25, 12345678901234ULL};

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &spu_record) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  printf("%d bytes\n", run(&record, NULL));
  printf("%d %03x %d %g\n", record.kind, record.flags, record.serial, record.u.number);
  printf("%d %g %llu\n", record.halves[0], record.exact, record.big);
  return 0;
}
