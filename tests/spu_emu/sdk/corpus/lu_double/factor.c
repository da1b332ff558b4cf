// Doolittle's factors in place, two doubles at once.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define N 16

static double a[N][N] __attribute__((aligned(128)));

static void move(void *ls, unsigned long long ea, unsigned int bytes, unsigned int command) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), bytes, 0, command);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long ea, unsigned long long unused) {
  int i, j, k;
  (void)spe;
  (void)unused;
  move(a, ea, sizeof a, MFC_GET_CMD);
  for (k = 0; k < N; k++) {
    for (i = k + 1; i < N; i++) {
      const double factor = a[i][k] / a[k][k];
      for (j = k / 2; j < N / 2; j++) {
        vec_double2 *row = (vec_double2 *)a[i] + j;
        *row = spu_nmsub(spu_splats(factor), ((vec_double2 *)a[k])[j], *row);
      }
      if (k % 2 == 1) a[i][k - 1] += factor * a[k][k - 1]; /* was taken along with its neighbour */
      a[i][k] = factor;
    }
  }
  move(a, ea, sizeof a, MFC_PUT_CMD);
  return 0;
}
