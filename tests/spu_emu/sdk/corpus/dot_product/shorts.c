#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static vec_short8 a[32] __attribute__((aligned(128))), b[32] __attribute__((aligned(128)));

static void move(void *ls, unsigned long long ea, unsigned int bytes, unsigned int command) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), bytes, 0, command);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long left, unsigned long long right) {
  vec_int4 sum = spu_splats(0);
  int i;
  (void)spe;
  move(a, left, sizeof a, MFC_GET_CMD);
  move(b, right, sizeof b, MFC_GET_CMD);
  for (i = 0; i < 32; i++) sum = spu_add(spu_madd(a[i], b[i], sum), spu_mule(a[i], b[i]));
  spu_write_out_mbox(spu_extract(sum, 0) + spu_extract(sum, 1) + spu_extract(sum, 2) + spu_extract(sum, 3));
  return 0;
}
