/* A stream through one buffer: get, wait, compute, put, wait. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "job.h"

#define TAG 5

static volatile job_t job __attribute__((aligned(128)));
static vec_float4 buffer[BLOCK / 16] __attribute__((aligned(128)));

static void wait_for_tag(void) {
  mfc_write_tag_mask(1 << TAG);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  unsigned int done, i;
  vec_float4 factor = spu_splats(FACTOR), offset;
  (void)spe;
  (void)envp;

  mfc_get(&job, argp, sizeof job, TAG, 0, 0);
  wait_for_tag();
  offset = spu_splats((float)job.offset);
  for (done = 0; done < job.bytes; done += BLOCK) {
    mfc_get(buffer, job.in + done, BLOCK, TAG, 0, 0);
    wait_for_tag();
    for (i = 0; i < BLOCK / 16; i++) buffer[i] = spu_madd(buffer[i], factor, offset);
    mfc_put(buffer, job.out + done, BLOCK, TAG, 0, 0);
    wait_for_tag();
  }
  return 0;
}
