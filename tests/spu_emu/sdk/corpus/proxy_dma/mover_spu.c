// The host moves the bytes in and out; this side only adds.
#include <spu_mfcio.h>

static volatile unsigned int words[256] __attribute__((aligned(128)));

int main(void) {
  unsigned int i;
  spu_write_out_mbox((unsigned int)words);
  while (spu_read_in_mbox() != 0) {
    for (i = 0; i < 256; i++) words[i] = words[i] * words[i] + i;
    spu_write_out_mbox(words[255]);
  }
  return 0;
}
