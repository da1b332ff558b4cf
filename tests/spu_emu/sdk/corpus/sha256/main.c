#include <spu_mfcio.h>

#include "sha256.h"

static unsigned int blocks[64] __attribute__((aligned(128)));
static unsigned int state[8] __attribute__((aligned(128))) = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                                              0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

int main(unsigned long long spe, unsigned long long ea, unsigned long long count) {
  unsigned int i;
  (void)spe;
  mfc_get(blocks, ea, sizeof blocks, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < count; i++) sha256_block(state, blocks + 16 * i);
  mfc_put(state, ea, sizeof state, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
