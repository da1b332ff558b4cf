#include <spu_mfcio.h>
#include <stdint.h>

static const int main_is_here = 3;

void main(uint64_t speid, uint64_t argp) {
  spu_write_out_mbox((uint32_t)argp + main_is_here);
  if (speid != 0) return;
  spu_stop(0x111);
}
