// Compare-exchange in whole vectors: partners at a distance of four or more lie in the same lane of other vectors; nearer
// ones are brought there by a rotation or a shuffle.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define N 256

static vec_int4 keys[N / 4] __attribute__((aligned(128)));

static void far_apart(int i, int j, int down) {
  const vec_int4 a = keys[i], b = keys[j];
  const vec_uint4 exchange = spu_xor(spu_cmpgt(a, b), spu_splats(down ? ~0u : 0u));
  keys[i] = spu_sel(a, b, exchange);
  keys[j] = spu_sel(b, a, exchange);
}

static void near_by(int i, int distance, int size) {
  const vec_uint4 lane = spu_add(spu_splats((unsigned int)(4 * i)), ((vec_uint4){0, 1, 2, 3}));
  const vec_uchar16 two = {8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7};
  const vec_uchar16 one = {4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11};
  const vec_int4 a = keys[i], b = spu_shuffle(a, a, distance == 2 ? two : one);
  const vec_uint4 upper = spu_cmpeq(spu_and(lane, distance), distance);
  const vec_uint4 down = spu_cmpeq(spu_and(lane, size), size);
  const vec_uint4 want_larger = spu_xor(upper, down);
  keys[i] = spu_sel(a, b, spu_sel(spu_cmpgt(a, b), spu_cmpgt(b, a), want_larger));
}

int main(unsigned long long id, unsigned long long ea, unsigned long long envp) {
  int size, distance, i;
  (void)id;
  (void)envp;
  mfc_get(keys, ea, sizeof keys, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (size = 2; size <= N; size *= 2) {
    for (distance = size / 2; distance > 0; distance /= 2) {
      for (i = 0; i < N / 4; i++) {
        if (distance < 4) {
          near_by(i, distance, size);
        } else if ((i & distance / 4) == 0) {
          far_apart(i, i + distance / 4, (4 * i & size) != 0);
        }
      }
    }
  }
  mfc_put(keys, ea, sizeof keys, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
