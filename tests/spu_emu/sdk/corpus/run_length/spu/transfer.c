#include "transfer.h"

unsigned char in[4096] __attribute__((aligned(128)));
unsigned char out[4096] __attribute__((aligned(128)));

void transfer(void *ls, unsigned long long ea, unsigned int command) {
  mfc_write_tag_mask(1 << 6);
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), sizeof in, 6, command);
  spu_mfcstat(MFC_TAG_UPDATE_ALL);
}
