#include <spu_intrinsics.h>
#include <spu_mfcio.h>
#include "record.h"

static record_t record;

static void move(void *ls, unsigned long long ea, unsigned int bytes, unsigned int command) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), bytes, 0, command);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long ea, unsigned long long unused) {
  (void)spe;
  (void)unused;
  move(&record, ea, sizeof record, MFC_GET_CMD);
  record.serial += record.kind;
  record.flags ^= 0xfff;
  record.u.bytes[0] ^= 0x80; /* the sign */
  record.halves[0] = record.halves[1] - record.halves[3];
  record.exact = record.exact * record.exact;
  record.big = record.big / 10 + record.halves[2];
  move(&record, ea, sizeof record, MFC_PUT_CMD);
  return sizeof record;
}
