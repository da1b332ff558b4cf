#include <spu_mfcio.h>

int main(unsigned long long spe, unsigned long long me, unsigned long long ticks) {
  unsigned int i;
  (void)spe;
  for (i = 0; i < ticks; i++) spu_write_out_intr_mbox(me << 16 | i);
  return me;
}
