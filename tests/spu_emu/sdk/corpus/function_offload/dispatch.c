#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "frame.h"

float dot(vec_float4 *a, vec_float4 *b, unsigned int quadwords);
float polynomial(float x, vec_float4 *coefficients, unsigned int quadwords);

static struct frame frame;
static vec_float4 vectors[2][256] __attribute__((aligned(128)));

static void fetch(void *ls, unsigned long long ea, unsigned int bytes) {
  mfc_get(ls, ea, bytes, 7, 0, 0);
  mfc_write_tag_mask(1 << 7);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  (void)spe;
  (void)envp;
  for (;;) {
    fetch(&frame, argp, sizeof frame);
    if (frame.function == 0) return 0;
    fetch(vectors[0], frame.vectors[0], frame.count * 4);
    if (frame.function == FUNCTION_DOT) {
      fetch(vectors[1], frame.vectors[1], frame.count * 4);
      frame.result = dot(vectors[0], vectors[1], frame.count / 4);
    } else {
      frame.result = polynomial(frame.argument, vectors[0], frame.count / 4);
    }
    mfc_put(&frame, argp, sizeof frame, 7, 0, 0);
    mfc_read_tag_status_all();
    spu_stop(STOP_NEXT);
  }
}
