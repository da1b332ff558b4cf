#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t fib, triple;

/* A mailbox holds one word: the SPE stops nowhere, so a thread of its own would be needed for more than that. */
static int run(spe_program_handle_t *program, void *argp, unsigned int *words, int count, unsigned int *answer) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, 0);
  if (!spe || spe_program_load(spe, program)) return -1;
  if (count) spe_in_mbox_write(spe, words, count, SPE_MBOX_ALL_BLOCKING);
  if (spe_context_run(spe, &entry, 0, argp, 0, &stop) < 0) return -2;
  if (spe_out_mbox_read(spe, answer, 1) != 1) *answer = 0;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  unsigned int words[2] = {1234, 0}, answer;
  int code = run(&fib, (void *)1, 0, 0, &answer);
  printf("fib: %u, exit code %d\n", answer, code);
  code = run(&triple, 0, words, 2, &answer);
  printf("triple: %u, exit code %d\n", answer, code);
  return 0;
}
