#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t sort;
static int keys[256] __attribute__((aligned(128)));

int main() {
  unsigned int entry = SPE_DEFAULT_ENTRY, state = 12345;
  int i, sorted = 1;
  spe_context_ptr_t spe = spe_context_create(0, 0);
  for (i = 0; i < 256; i++) {
    state = state * 1664525 + 1013904223;
    keys[i] = (int)state >> 12;
  }
  spe_program_load(spe, &sort);
  if (spe_context_run(spe, &entry, 0, keys, 0, 0)) return 1;
  for (i = 1; i < 256; i++) sorted &= keys[i - 1] <= keys[i];
  printf("%s: %d %d ... %d %d ... %d\n", sorted ? "sorted" : "WRONG", keys[0], keys[1], keys[127], keys[128], keys[255]);
  return 0;
}
