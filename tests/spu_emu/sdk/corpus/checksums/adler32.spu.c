#include <spu_mfcio.h>

static unsigned char buffer[8192] __attribute__((aligned(128)));

static unsigned int checksum(const unsigned char *bytes, unsigned int count) {
  unsigned int a = 1, b = 0;
  while (count-- > 0) {
    a = (a + *bytes++) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

/* The count of bytes in envp; the checksum by the mailbox. */
int main(unsigned long long spe, unsigned long long ea, unsigned long long count) {
  (void)spe;
  mfc_get(buffer, ea, (count + 15) & ~15ull, 5, 0, 0);
  mfc_write_tag_mask(1 << 5);
  mfc_read_tag_status_all();
  spu_write_out_mbox(checksum(buffer, (unsigned int)count));
  return 0;
}
