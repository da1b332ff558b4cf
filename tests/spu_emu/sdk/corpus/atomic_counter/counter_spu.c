/* Adds to a counter that other SPEs and the host add to as well: load and reserve, store conditionally. */
#include <spu_mfcio.h>

static volatile unsigned int line[32] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long counter, unsigned long long times) {
  unsigned long long i;
  (void)spe;
  for (i = 0; i < times; i++) {
    do {
      mfc_getllar(line, counter, 0, 0);
      mfc_read_atomic_status();
      line[0]++;
      mfc_putllc(line, counter, 0, 0);
    } while (mfc_read_atomic_status() & MFC_PUTLLC_STATUS);
  }
  return 0;
}
