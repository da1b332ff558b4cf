// Serves requests of three words, the operation and its operands, and answers in the mailbox that interrupts.
#include <spu_mfcio.h>

#include "protocol.h"

static unsigned int square_root(unsigned int of) {
  unsigned int root = 0;
  for (unsigned int bit = 1u << 15; bit != 0; bit >>= 1) {
    if ((root | bit) * (root | bit) <= of) root |= bit;
  }
  return root;
}

int main(void) {
  unsigned int served = 0;
  for (;;) {
    unsigned int operation = spu_read_in_mbox();
    if (operation == QUIT) break;
    unsigned int a = spu_read_in_mbox();
    unsigned int b = spu_read_in_mbox();
    served++;
    switch (operation) {
      case ADD:
        spu_write_out_intr_mbox(a + b);
        break;
      case MULTIPLY:
        spu_write_out_intr_mbox(a * b);
        break;
      case SQUARE_ROOT:
        spu_write_out_intr_mbox(square_root(a));
        break;
      default:
        spu_write_out_intr_mbox(0);
    }
  }
  spu_write_out_mbox(served);
  return served;
}
