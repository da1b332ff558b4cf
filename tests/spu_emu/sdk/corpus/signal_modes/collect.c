// Says that it is there, waits until the host has written, and gives back what both registers have.
#include <spu_mfcio.h>

int main(void) {
  spu_write_out_mbox(spu_stat_signal1() << 1 | spu_stat_signal2());
  (void)spu_read_in_mbox();
  spu_write_out_mbox(spu_read_signal1());
  (void)spu_read_in_mbox();
  spu_write_out_mbox(spu_read_signal2());
  return spu_stat_signal1() | spu_stat_signal2();
}
