#include <spu_mfcio.h>
#include <string.h>

static struct {
  char pattern[64];
  char text[1024];
} block __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long size) {
  unsigned char skip[256];
  int i, length, at, found = 0;
  (void)spe;
  mfc_get(&block, ea, sizeof block, 3, 0, 0);
  mfc_write_tag_mask(1 << 3);
  mfc_read_tag_status_all();
  length = strlen(block.pattern);
  memset(skip, length, sizeof skip);
  for (i = 0; i < length - 1; i++) skip[(unsigned char)block.pattern[i]] = length - 1 - i;
  for (at = 0; at + length <= (int)size; at += skip[(unsigned char)block.text[at + length - 1]]) {
    if (memcmp(block.text + at, block.pattern, length) == 0) {
      if (found++ == 0) spu_write_out_mbox(at);
    }
  }
  return found;
}
