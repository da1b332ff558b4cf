#include <simdmath.h>
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static unsigned char row[SIDE] __attribute__((aligned(16)));

/* Parallel rays on a sphere at the origin, light from the left above; structure of arrays, four rays at once. */
static vec_float4 brightness(vec_float4 x, vec_float4 y) {
  const vec_float4 zero = spu_splats(0.0f), third = spu_splats(0.57735f);
  const vec_float4 zz = spu_nmsub(x, x, spu_nmsub(y, y, spu_splats(1.0f)));
  const vec_uint4 hit = spu_cmpgt(zz, zero);
  const vec_float4 z = sqrtf4(spu_sel(zero, zz, hit));
  const vec_float4 light = spu_mul(third, spu_sub(spu_sub(z, x), y));
  return spu_sel(spu_splats(-1.0f), fmaxf4(light, zero), hit);
}

int main(unsigned long long spe, unsigned long long image, unsigned long long unused) {
  int i, j, k;
  (void)spe;
  (void)unused;
  for (i = 0; i < SIDE; i++) {
    for (j = 0; j < SIDE; j += 4) {
      const vec_float4 x = {j - SIDE / 2 + 0.5f, j - SIDE / 2 + 1.5f, j - SIDE / 2 + 2.5f, j - SIDE / 2 + 3.5f};
      const vec_float4 scale = spu_splats(2.2f / SIDE);
      const vec_float4 shade = brightness(spu_mul(x, scale), spu_mul(spu_splats(i - SIDE / 2 + 0.5f), scale));
      for (k = 0; k < 4; k++) {
        const float s = spu_extract(shade, k);
        row[j + k] = s < 0 ? ' ' : ".:-=+*#%@"[(int)(s * 8.99f)];
      }
    }
    mfc_put(row, image + i * SIDE, SIDE, 0, 0, 0);
    mfc_write_tag_mask(1);
    mfc_read_tag_status_all();
  }
  return 0;
}
