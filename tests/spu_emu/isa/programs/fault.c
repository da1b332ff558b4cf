/* Breaks a rule of the MFC in a function with a name. */
#include <spu_mfcio.h>

static char buffer[64] __attribute__((aligned(128)));

__attribute__((noinline)) void misaligned_get(unsigned long long from) {
  mfc_get(buffer + 4, from, 16, 3, 0, 0);
  mfc_write_tag_mask(1 << 3);
  mfc_read_tag_status_all();
}

int main(unsigned long long speid, unsigned long long argp) {
  (void)speid;
  misaligned_get(argp);
  return 0;
}
