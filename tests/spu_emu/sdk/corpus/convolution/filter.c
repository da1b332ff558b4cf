// Sobel's operator on bytes: each is widened to 16 bits by a shuffle, and the sums are saturated by a comparison.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define SIDE 32

static unsigned char image[SIDE][SIDE] __attribute__((aligned(128)));
static unsigned char edges[SIDE][SIDE] __attribute__((aligned(128)));

static void move(void *ls, unsigned long long ea, unsigned int bytes, unsigned int command) {
  spu_mfcdma64(ls, mfc_ea2h(ea), mfc_ea2l(ea), bytes, 0, command);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

static short at(int i, int j) {
  return image[i & (SIDE - 1)][j & (SIDE - 1)];
}

int main(unsigned long long spe, unsigned long long from, unsigned long long to) {
  const vec_uchar16 low_bytes = {1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31};
  int i, j, k;
  (void)spe;
  move(image, from, sizeof image, MFC_GET_CMD);
  for (i = 0; i < SIDE; i++) {
    for (j = 0; j < SIDE; j += 16) {
      vec_short8 sums[2];
      for (k = 0; k < 16; k++) {
        const int c = j + k;
        const short x = at(i - 1, c + 1) + 2 * at(i, c + 1) + at(i + 1, c + 1) - at(i - 1, c - 1) - 2 * at(i, c - 1) - at(i + 1, c - 1);
        const short y = at(i + 1, c - 1) + 2 * at(i + 1, c) + at(i + 1, c + 1) - at(i - 1, c - 1) - 2 * at(i - 1, c) - at(i - 1, c + 1);
        sums[k / 8] = spu_insert((short)((x < 0 ? -x : x) + (y < 0 ? -y : y)), sums[k / 8], k % 8);
      }
      for (k = 0; k < 2; k++) sums[k] = spu_sel(sums[k], spu_splats((short)255), spu_cmpgt(sums[k], 255));
      *(vec_uchar16 *)&edges[i][j] = (vec_uchar16)spu_shuffle(sums[0], sums[1], low_bytes);
    }
  }
  move(edges, to, sizeof edges, MFC_PUT_CMD);
  return 0;
}
