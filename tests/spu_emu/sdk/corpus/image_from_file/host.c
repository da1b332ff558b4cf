#include <libspe2.h>
#include <stdio.h>

static unsigned int primes[1024] __attribute__((aligned(128)));

int main(int argc, char **argv) {
  unsigned int entry = SPE_DEFAULT_ENTRY, count = 0;
  spe_program_handle_t *program = spe_image_open(argc > 1 ? argv[1] : "sieve");
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (!program) {
    perror("spe_image_open");
    return 1;
  }
  if (spe_program_load(spe, program) || spe_context_run(spe, &entry, 0, primes, NULL, NULL)) return 1;
  spe_out_mbox_read(spe, &count, 1);
  printf("%u primes, the last is %u\n", count, primes[count - 1]);
  spe_context_destroy(spe);
  return spe_image_close(program);
}
