// Sends every message of its mailbox back, and ends at 0.
#include <spu_mfcio.h>

int main(unsigned long long, unsigned long long, unsigned long long) {
  while (const unsigned int message = spu_read_in_mbox()) spu_write_out_intr_mbox(message);
  return 0;
}
