#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static vec_int4 length[NODES][NODES / 4] __attribute__((aligned(128)));

static void move(void *ls, unsigned long long ea, unsigned int bytes, unsigned int command) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), bytes, 0, command);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long ea, unsigned long long unused) {
  int i, j, k;
  (void)spe;
  (void)unused;
  move(length, ea, sizeof length, MFC_GET_CMD);
  for (k = 0; k < NODES; k++) {
    for (i = 0; i < NODES; i++) {
      const vec_int4 to_k = spu_splats(spu_extract(length[i][k / 4], k % 4));
      for (j = 0; j < NODES / 4; j++) {
        const vec_int4 through = spu_add(to_k, length[k][j]);
        length[i][j] = spu_sel(length[i][j], through, spu_cmpgt(length[i][j], through));
      }
    }
  }
  move(length, ea, sizeof length, MFC_PUT_CMD);
  return 0;
}
