#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "job.h"

namespace {

Job job;
volatile unsigned int line[32] __attribute__((aligned(128)));
unsigned char row[256] __attribute__((aligned(128)));

int next_row() {
  unsigned int number;
  do {
    mfc_getllar(line, job.counter, 0, 0);
    mfc_read_atomic_status();
    number = line[0]++;
    mfc_putllc(line, job.counter, 0, 0);
  } while (mfc_read_atomic_status() & MFC_PUTLLC_STATUS);
  return number;
}

/// Four points of a row at once: how many steps each stays within 2.
vec_int4 steps(vec_float4 x, vec_float4 y) {
  vec_float4 a = spu_splats(0.0f), b = a;
  vec_int4 count = spu_splats(0);
  for (int i = 0; i < job.limit; ++i) {
    const vec_float4 aa = spu_mul(a, a), bb = spu_mul(b, b);
    const vec_uint4 inside = spu_cmpgt(spu_splats(4.0f), spu_add(aa, bb));
    if (spu_extract(spu_gather(inside), 0) == 0) break;
    count = spu_sub(count, (vec_int4)inside);
    b = spu_madd(spu_add(a, a), b, y);
    a = spu_add(spu_sub(aa, bb), x);
  }
  return count;
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  mfc_get(&job, argp, sizeof job, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  const vec_float4 lanes = {0, 1, 2, 3};
  int rows = 0;
  for (int j = next_row(); j < job.height; j = next_row(), ++rows) {
    const vec_float4 y = spu_splats(-1.25f + 0.125f * j);
    for (int i = 0; i < job.width; i += 4) {
      const vec_float4 x = spu_madd(spu_add(spu_splats((float)i), lanes), spu_splats(0.0625f), spu_splats(-2.0f));
      const vec_int4 count = steps(x, y);
      for (int k = 0; k < 4; ++k) row[i + k] = " .:-=+*%#"[spu_extract(count, k) * 8 / job.limit];
    }
    mfc_put(row, job.image + j * job.width, job.width, 0, 0, 0);
    mfc_read_tag_status_all();
  }
  return rows > 255 ? 255 : rows;
}
