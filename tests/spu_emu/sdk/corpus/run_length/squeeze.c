#include <libspe2.h>
#include <stdio.h>
#include <string.h>

extern spe_program_handle_t pack, unpack;
static unsigned char block[4096] __attribute__((aligned(128)));
static unsigned char kept[4096];

static unsigned int run(spe_program_handle_t *program, unsigned long size) {
  unsigned int entry = SPE_DEFAULT_ENTRY, made = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_program_load(spe, program) || spe_context_run(spe, &entry, 0, block, (void *)size, NULL)) return 0;
  spe_out_mbox_read(spe, &made, 1);
  spe_context_destroy(spe);
  return made;
}

int main(void) {
  unsigned int i, packed, unpacked;
  for (i = 0; i < 4096; i++) kept[i] = block[i] = i < 2000 ? i / 100 : i / 7 % 3;
  packed = run(&pack, 4096);
  unpacked = run(&unpack, packed);
  printf("4096 -> %u -> %u bytes, %s\n", packed, unpacked, memcmp(kept, block, 4096) ? "DIFFERENT" : "equal");
  return 0;
}
