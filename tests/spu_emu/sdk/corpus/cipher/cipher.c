#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t xtea;
static unsigned int block[124] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &xtea) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

static void decipher(unsigned int *v, const unsigned int *key) {
  unsigned int sum = 0x9e3779b9u * 32;
  while (sum != 0) {
    v[1] -= ((v[0] << 4 ^ v[0] >> 5) + v[0]) ^ (sum + key[sum >> 11 & 3]);
    sum -= 0x9e3779b9u;
    v[0] -= ((v[1] << 4 ^ v[1] >> 5) + v[1]) ^ (sum + key[sum & 3]);
  }
}

int main(void) {
  int i, wrong = 0;
  for (i = 0; i < 124; i++) block[i] = i < 4 ? i * 0x04040404u + 0x00010203u : i * 0x01000193u;
  if (run(block, (void *)32)) return 1;
  printf("%08x %08x %08x\n", block[4], block[5], block[123]);
  for (i = 4; i < 124; i += 2) decipher(block + i, block);
  for (i = 4; i < 124; i++) wrong += block[i] != i * 0x01000193u;
  printf("%d wrong\n", wrong);
  return 0;
}
