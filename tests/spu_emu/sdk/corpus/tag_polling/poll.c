/* Several groups of transfers under way; which are done is asked without waiting, then for any, then for all. */
#include <spu_mfcio.h>

static int data[4][1024] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long envp)
{
  unsigned int mask = 0, done, tag, rounds = 0, sum = 0;
  int i;
  (void)spe;
  (void)envp;
  for (tag = 0; tag < 4; tag++) {
    mfc_get(data[tag], ea + tag * sizeof data[0], sizeof data[0], 10 + tag, 0, 0);
    mask |= 1 << (10 + tag);
  }
  spu_write_out_mbox(mfc_stat_cmd_queue() <= 16);
  while (mask != 0) {
    mfc_write_tag_mask(mask);
    done = rounds++ % 2 ? mfc_read_tag_status_immediate() : mfc_read_tag_status_any();
    for (tag = 0; tag < 4; tag++) {
      if (done & 1 << (10 + tag)) {
        for (i = 0; i < 1024; i++) sum += data[tag][i] * (tag + 1);
        data[tag][0] = -(int)tag;
        mfc_putf(data[tag], ea + tag * sizeof data[0], 16, 10 + tag, 0, 0);
      }
    }
    mask &= ~done;
  }
  mfc_write_tag_mask(15 << 10);
  mfc_write_tag_update_all();
  while (mfc_stat_tag_status() == 0) {
  }
  if (mfc_read_tag_status() != 15 << 10) return 1;
  return sum % 200;
}
