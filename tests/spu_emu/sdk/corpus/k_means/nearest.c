// Each point's nearest centre, and the sums for the next centres; points lie in the local store from call to call.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define POINTS 64
#define CENTRES 4

static struct {
  vec_float4 centres[CENTRES];
  vec_float4 points[POINTS];
} block __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long rounds) {
  unsigned int round, i, k, moved = 1;
  (void)spe;
  mfc_get(&block, ea, sizeof block, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (round = 0; round < rounds && moved; round++) {
    vec_float4 sums[CENTRES] = {{0}};
    for (i = 0; i < POINTS; i++) {
      unsigned int best = 0;
      float least = 1e30f;
      for (k = 0; k < CENTRES; k++) {
        const vec_float4 d = spu_sub(block.points[i], block.centres[k]), dd = spu_mul(d, d);
        const float distance = spu_extract(dd, 0) + spu_extract(dd, 1);
        if (distance < least) least = distance, best = k;
      }
      sums[best] = spu_add(sums[best], spu_insert(1.0f, block.points[i], 3));
    }
    for (moved = k = 0; k < CENTRES; k++) {
      const float count = spu_extract(sums[k], 3);
      const vec_float4 centre = {spu_extract(sums[k], 0) / count, spu_extract(sums[k], 1) / count, 0, count};
      moved |= spu_extract(centre, 0) != spu_extract(block.centres[k], 0) || spu_extract(centre, 3) != spu_extract(block.centres[k], 3);
      block.centres[k] = centre;
    }
  }
  mfc_put(&block, ea, sizeof block.centres, 0, 0, 0);
  mfc_read_tag_status_all();
  return round;
}
