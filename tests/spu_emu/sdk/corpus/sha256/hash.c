#include <libspe2.h>
#include <stdio.h>
#include <string.h>
extern spe_program_handle_t digest;
static unsigned char block[256] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &digest) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

/* A Cell is big-endian, and so is the hash: its words are those of the memory. */
static void hash(const char *text) {
  unsigned long size = strlen(text), count = (size + 8) / 64 + 1;
  int i;
  memset(block, 0, sizeof block);
  memcpy(block, text, size);
  block[size] = 0x80;
  *(unsigned int *)(block + 64 * count - 4) = size * 8;
  if (run(block, (void *)count)) return;
  for (i = 0; i < 32; i++) printf("%02x", block[i]);
  printf(" %lu\n", size);
}

int main(void) {
  hash("");
  hash("abc");
  hash("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq");
  return 0;
}
