/* In place through three buffers: one is on its way in, one is worked on, one is on its way out. A buffer's get follows
   its put by a fence, so that nobody waits for the put. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define BYTES 2048
#define LINES (BYTES / 16)

static vec_uint4 buffers[3][LINES] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long count) {
  unsigned int i, j;
  (void)spe;
  mfc_get(buffers[0], ea, BYTES, 0, 0, 0);
  for (i = 0; i < count; i++) {
    unsigned int now = i % 3, next = (i + 1) % 3;
    if (i + 1 < count) mfc_getf(buffers[next], ea + (i + 1) * BYTES, BYTES, next, 0, 0);
    mfc_write_tag_mask(1 << now);
    mfc_read_tag_status_all();
    for (j = 0; j < LINES; j++) buffers[now][j] = spu_xor(spu_rl(buffers[now][j], 7), spu_splats(0xa5a5a5a5u));
    mfc_put(buffers[now], ea + i * BYTES, BYTES, now, 0, 0);
  }
  mfc_write_tag_mask(7);
  mfc_read_tag_status_all();
  return 0;
}
