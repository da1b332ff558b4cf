#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t stops;


int main() {
  unsigned int entry = SPE_DEFAULT_ENTRY, word = 40;
  spe_stop_info_t stop;
  int code;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  spe_program_load(spe, &stops);
  while ((code = spe_context_run(spe, &entry, 0, NULL, NULL, &stop)) > 0) {
    printf("stopped with %x, reason %s\n", code, stop.stop_reason == SPE_STOP_AND_SIGNAL ? "signal" : "other");
    spe_in_mbox_write(spe, &word, 1, SPE_MBOX_ALL_BLOCKING);
    word = 2;
  }
  printf("exit code %d\n", stop.result.spe_exit_code);
  return code;
}
