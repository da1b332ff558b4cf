#include "transfer.h"

int main(unsigned long long spe, unsigned long long ea, unsigned long long size) {
  unsigned int i, run, made = 0;
  (void)spe;
  transfer(in, ea, MFC_GET_CMD);
  for (i = 0; i < size; i += run, made += 2) {
    for (run = 1; run < 255 && i + run < size && in[i + run] == in[i]; run++) {
    }
    out[made] = run;
    out[made + 1] = in[i];
  }
  transfer(out, ea, MFC_PUT_CMD);
  spu_write_out_mbox(made);
  return 0;
}
