// 128 points, radix 2, decimation in time, in place.
#include <spu_mfcio.h>

#include "twiddle.h"

#define N 128

static float x[N][2] __attribute__((aligned(128)));

static void reverse_bits(void) {
  for (unsigned int i = 0; i < N; i++) {
    unsigned int j = 0;
    for (unsigned int bit = 1; bit < N; bit <<= 1) j = j << 1 | ((i & bit) != 0);
    if (i < j) {
      for (int part = 0; part < 2; part++) {
        float kept = x[i][part];
        x[i][part] = x[j][part];
        x[j][part] = kept;
      }
    }
  }
}

static void butterfly(float a[2], float b[2], const float w[2]) {
  float re = b[0] * w[0] - b[1] * w[1];
  float im = b[0] * w[1] + b[1] * w[0];
  b[0] = a[0] - re;
  b[1] = a[1] - im;
  a[0] += re;
  a[1] += im;
}

int main(unsigned long long spe, unsigned long long ea) {
  (void)spe;
  mfc_get(x, ea, sizeof x, 9, 0, 0);
  mfc_write_tag_mask(1 << 9);
  mfc_read_tag_status_all();
  reverse_bits();
  for (int half = 1; half < N; half *= 2) {
    for (int first = 0; first < N; first += 2 * half) {
      for (int k = 0; k < half; k++) butterfly(x[first + k], x[first + k + half], twiddle[k * (N / 2 / half)]);
    }
  }
  mfc_put(x, ea, sizeof x, 9, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
