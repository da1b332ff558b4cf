#include <libspe2.h>
#include <stdio.h>

#define COUNT 10
#define WORDS 512

extern spe_program_handle_t stream_spu;
static unsigned int data[COUNT * WORDS] __attribute__((aligned(128)));

int main() {
  unsigned int entry = SPE_DEFAULT_ENTRY, i, hash = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < COUNT * WORDS; i++) data[i] = i * 40503u;
  spe_program_load(spe, &stream_spu);
  if (spe_context_run(spe, &entry, 0, data, (void *)COUNT, NULL) != 0) return 1;
  for (i = 0; i < COUNT * WORDS; i++) hash = hash * 31 + data[i];
  printf("%08x %08x %08x\n", data[1], data[COUNT * WORDS - 1], hash);
  return spe_context_destroy(spe);
}
