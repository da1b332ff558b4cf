#include <spu_intrinsics.h>
#include <spu_mfcio.h>
#include <vec_literal.h>

static vec_uint4 rows[4] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long unused) {
  const vec_uchar16 high = VEC_LITERAL(vec_uchar16, 0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23);
  const vec_uchar16 low = VEC_LITERAL(vec_uchar16, 8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31);
  vec_uint4 a, b, c, d;
  (void)spe;
  (void)unused;
  mfc_get(rows, ea, sizeof rows, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  a = spu_shuffle(rows[0], rows[2], high), b = spu_shuffle(rows[1], rows[3], high);
  c = spu_shuffle(rows[0], rows[2], low), d = spu_shuffle(rows[1], rows[3], low);
  rows[0] = spu_shuffle(a, b, high), rows[1] = spu_shuffle(a, b, low);
  rows[2] = spu_shuffle(c, d, high), rows[3] = spu_shuffle(c, d, low);
  mfc_put(rows, ea, sizeof rows, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
