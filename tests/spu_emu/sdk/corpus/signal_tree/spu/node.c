/* Each leaf signals its parent; a node that has heard of both children, whose bits a register in OR mode collects, signals
 * its own parent; the root tells the host. Then the way down releases all. */
#include <spu_mfcio.h>

#include "tree.h"

static setup_t setup;
/* A signal's word has the register's place within its quadword, 12. */
static volatile unsigned int word[4] __attribute__((aligned(16)));

static void send(unsigned int to, unsigned int bits) {
  word[3] = bits;
  mfc_sndsig(&word[3], setup.signal1[to], 1, 0, 0);
  mfc_write_tag_mask(1 << 1);
  mfc_read_tag_status_all();
}

int main(unsigned long long id, unsigned long long argp) {
  unsigned int heard = 0, node, left;
  (void)id;
  mfc_get(&setup, argp, sizeof setup, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  node = setup.node;
  left = 2 * node + 1;
  if (left < NODES) {
    while (heard != 3) heard |= spu_read_signal1();
  }
  if (node == 0) {
    spu_write_out_intr_mbox(0xcafe);
  } else {
    send((node - 1) / 2, node % 2 ? 1 : 2);
    spu_read_signal1();
  }
  if (left < NODES) {
    send(left, 4);
    send(left + 1, 4);
  }
  return node + 1;
}
