#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "ring.h"

static struct link link __attribute__((aligned(16)));
/* Where the neighbour puts its token: at the same place in every local store, as every SPE has this program. */
static volatile unsigned int inbox[4] __attribute__((aligned(128)));
static volatile unsigned int outbox[4] __attribute__((aligned(128)));

static void pass(void) {
  mfc_put(outbox, link.next + (unsigned int)inbox, sizeof outbox, 1, 0, 0);
  mfc_write_tag_mask(1 << 1);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  unsigned int round;
  (void)spe;
  (void)envp;
  mfc_get(&link, argp, sizeof link, 1, 0, 0);
  mfc_write_tag_mask(1 << 1);
  mfc_read_tag_status_all();
  (void)spu_read_in_mbox(); /* all have their program */
  for (round = 1; round <= ROUNDS; round++) {
    unsigned int token = round * 10;
    if (link.number != 0) {
      while (inbox[3] != round) spu_sync();
      token = inbox[0];
    }
    outbox[0] = token * 2 + link.number;
    outbox[3] = round;
    pass();
    if (link.number == 0) {
      while (inbox[3] != round) spu_sync();
      spu_write_out_mbox(inbox[0]);
    }
  }
  return 0;
}
