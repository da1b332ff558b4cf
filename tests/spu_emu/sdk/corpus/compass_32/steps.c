// The ends of walks: each the sum of its steps to the east and to the north.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static int steps[8][8] __attribute__((aligned(128)));
static int ends[8][2] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long from, unsigned long long to) {
  int walk, step;
  (void)spe;
  mfc_get(steps, from, sizeof steps, 3, 0, 0);
  mfc_write_tag_mask(1 << 3);
  mfc_read_tag_status_all();
  for (walk = 0; walk < 8; walk++) {
    for (step = 0; step < 8; step++) ends[walk][step % 2] += steps[walk][step];
  }
  mfc_put(ends, to, sizeof ends, 3, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
