/* Each SPE sums its part and tells the next what came before, through that one's signal register. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "part.h"

static struct part part __attribute__((aligned(16)));
static vec_uint4 words[WORDS / 4] __attribute__((aligned(128)));
static unsigned int message[4] __attribute__((aligned(16)));

int main(unsigned long long spe, unsigned long long argp, unsigned long long first) {
  vec_uint4 carry = spu_splats(0u);
  unsigned int before = 0;
  int i;
  (void)spe;
  mfc_write_tag_mask(1);
  mfc_get(&part, argp, sizeof part, 0, 0, 0);
  mfc_read_tag_status_all();
  mfc_get(words, part.words, sizeof words, 0, 0, 0);
  mfc_read_tag_status_all();
  for (i = 0; i < WORDS / 4; i++) {
    vec_uint4 v = words[i];
    v = spu_add(v, spu_rlmaskqwbyte(v, -4));
    v = spu_add(v, spu_rlmaskqwbyte(v, -8));
    words[i] = spu_add(v, carry);
    carry = spu_splats(spu_extract(words[i], 3));
  }
  if (!first) before = spu_read_signal1();
  if (part.next_signal) {
    message[3] = before + spu_extract(carry, 0); /* a signal's word lies in its quadword as the register does */
    mfc_sndsig(&message[3], part.next_signal, 0, 0, 0);
    mfc_read_tag_status_all();
  }
  for (i = 0; i < WORDS / 4; i++) words[i] = spu_add(words[i], spu_splats(before));
  mfc_put(words, part.words, sizeof words, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
