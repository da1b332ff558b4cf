#include <spu_intrinsics.h>
#include <spu_mfcio.h>

/* Stops with codes of its own; the host goes on from there as often as it likes. */
int main(void) {
  unsigned int sum = 0;
  spu_stop(0x11);
  sum += spu_read_in_mbox();
  spu_stop(0x22);
  sum += spu_read_in_mbox();
  spu_stop(0x33);
  return sum;
}
