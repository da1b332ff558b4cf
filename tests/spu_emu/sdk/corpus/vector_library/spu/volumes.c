#include <spu_mfcio.h>
#include <vec3.h>

static vec_float4 edges[3 * 20] __attribute__((aligned(128)));
static float volume[20] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long from, unsigned long long to) {
  int i;
  (void)spe;
  mfc_get(edges, from, sizeof edges, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 20; i++) volume[i] = vec3_dot(vec3_cross(edges[3 * i], edges[3 * i + 1]), edges[3 * i + 2]);
  mfc_put(volume, to, sizeof volume, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
