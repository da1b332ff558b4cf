#include <spu_mfcio.h>

int main(void) {
  unsigned int word;
  while ((word = spu_read_in_mbox()) != 0) spu_write_out_mbox(word + STEP);
  return 0;
}
