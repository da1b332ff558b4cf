// SPU side of the ping-pong: answers every message with its successor, and ends at 0.
#include <spu_mfcio.h>

int main(unsigned long long, unsigned long long, unsigned long long) {
  while (const unsigned int message = spu_read_in_mbox()) spu_write_out_intr_mbox(message + 1);
  return 0;
}
