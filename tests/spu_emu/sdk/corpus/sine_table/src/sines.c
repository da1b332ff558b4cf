// Sines of angles, by the library's vectors; their logarithms' exponentials, by whole arrays.
#include <massv.h>
#include <simdmath.h>
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static vec_float4 x[64] __attribute__((aligned(128)));
static vec_float4 y[64] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long angles, unsigned long long sines) {
  int i, n = 256;
  (void)spe;
  mfc_get(x, angles, sizeof x, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 64; i++) y[i] = spu_add(sinf4(x[i]), spu_splats(2.0f));
  vslog((float *)y, (float *)y, &n);
  vsexp((float *)y, (float *)y, &n);
  mfc_put(y, sines, sizeof y, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
