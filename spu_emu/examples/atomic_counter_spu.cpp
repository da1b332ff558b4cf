// SPU side of the atomic counter: adds one to a counter in main memory many times, with getllar and putllc.
#include <malloc_align.h>
#include <spu_mfcio.h>

int main(unsigned long long, unsigned long long argp, unsigned long long envp) {
  auto* line = static_cast<volatile unsigned int*>(_malloc_align(128, 7));
  for (unsigned long long i = 0; i < envp; ++i) {
    do {
      mfc_getllar(line, argp, 0, 0);
      mfc_read_atomic_status();
      line[0] = line[0] + 1;
      mfc_putllc(line, argp, 0, 0);
    } while ((mfc_read_atomic_status() & MFC_PUTLLC_STATUS) != 0);
  }
  return 0;
}
