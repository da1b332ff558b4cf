#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "sum.h"

static struct control control;
static vec_uint4 buffers[2][CHUNK / 16] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  vec_uint4 total = spu_splats(0u);
  unsigned int current = 0, chunk, i;
  (void)spe;
  (void)envp;

  mfc_get(&control, argp, sizeof control, 31, 0, 0);
  mfc_write_tag_mask(1u << 31);
  mfc_read_tag_status_all();

  mfc_get(buffers[0], control.ea, CHUNK, 0, 0, 0);
  for (chunk = 0; chunk < control.chunks; chunk++) {
    unsigned int next = current ^ 1;
    if (chunk + 1 < control.chunks) {
      mfc_get(buffers[next], control.ea + (unsigned long long)(chunk + 1) * CHUNK, CHUNK, next, 0, 0);
    }
    mfc_write_tag_mask(1u << current);
    mfc_read_tag_status_all();
    for (i = 0; i < CHUNK / 16; i++) total = spu_add(total, buffers[current][i]);
    current = next;
  }
  control.result = spu_extract(total, 0) + spu_extract(total, 1) + spu_extract(total, 2) + spu_extract(total, 3);
  mfc_put(&control, argp, sizeof control, 31, 0, 0);
  mfc_write_tag_mask(1u << 31);
  mfc_read_tag_status_all();
  return 0;
}
