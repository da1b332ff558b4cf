#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t popcount_spu;
static unsigned int words[128] __attribute__((aligned(128)));

int main(void) {
  unsigned int bytes, i, n, right, got;
  for (i = 0; i < 128; i++) words[i] = i * 0x9e3779b9u;
  for (bytes = 16; bytes <= 512; bytes *= 2) {
    unsigned int entry = SPE_DEFAULT_ENTRY;
    spe_context_ptr_t spe = spe_context_create(0, NULL);
    for (i = right = 0; i < bytes / 4; i++) {
      for (n = words[i]; n != 0; n &= n - 1) right++;
    }
    spe_program_load(spe, &popcount_spu);
    if (spe_context_run(spe, &entry, 0, words, (void *)bytes, NULL) || spe_out_mbox_read(spe, &got, 1) != 1) return 1;
    printf("%3u bytes: %4u bits, %s\n", bytes, got, got == right ? "right" : "WRONG");
    spe_context_destroy(spe);
  }
  return 0;
}
