#include "transfer.h"

int main(unsigned long long spe, unsigned long long ea, unsigned long long size) {
  unsigned int i, run, made = 0;
  (void)spe;
  transfer(in, ea, MFC_GET_CMD);
  for (i = 0; i < size; i += 2) {
    for (run = in[i]; run > 0; run--) out[made++] = in[i + 1];
  }
  transfer(out, ea, MFC_PUT_CMD);
  spu_write_out_mbox(made);
  return 0;
}
