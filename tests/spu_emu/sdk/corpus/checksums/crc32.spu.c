#include <spu_mfcio.h>

static unsigned char buffer[8192] __attribute__((aligned(128)));

static unsigned int table[256];

static void make_table(void) {
  unsigned int i, bit;
  for (i = 0; i < 256; i++) {
    unsigned int value = i;
    for (bit = 0; bit < 8; bit++) value = value & 1 ? 0xedb88320u ^ value >> 1 : value >> 1;
    table[i] = value;
  }
}

static unsigned int checksum(const unsigned char *bytes, unsigned int count) {
  unsigned int crc = ~0u;
  make_table();
  while (count-- > 0) crc = table[(crc ^ *bytes++) & 0xff] ^ crc >> 8;
  return ~crc;
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
