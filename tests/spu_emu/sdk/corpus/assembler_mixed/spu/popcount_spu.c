#include <spu_mfcio.h>

extern unsigned int bits(const void *from, unsigned int quadwords);

static unsigned int words[128] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long bytes) {
  (void)spe;
  mfc_get(words, ea, bytes, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  spu_write_out_mbox(bits(words, bytes / 16));
  return 0;
}
