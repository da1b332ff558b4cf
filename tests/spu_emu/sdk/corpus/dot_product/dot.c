#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t shorts;
static short a[256] __attribute__((aligned(128))), b[256] __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY, got;
  int i, sum = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < 256; i++) sum += (a[i] = i * 97 - 9000) * (b[i] = 5000 - i * i % 7000);
  spe_program_load(spe, &shorts);
  if (spe_context_run(spe, &entry, 0, a, b, NULL) || spe_out_mbox_read(spe, &got, 1) != 1) return 1;
  printf("%d, here %d\n", (int)got, sum);
  return 0;
}
