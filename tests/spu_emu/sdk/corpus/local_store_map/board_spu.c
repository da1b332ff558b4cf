// The host writes and reads the local store itself, through its mapping; this side looks at a flag.
#include <spu_mfcio.h>

static volatile struct {
  unsigned int flag;
  unsigned int numbers[31];
} board __attribute__((aligned(128)));

int main(void) {
  unsigned int round, i;
  spu_write_out_mbox((unsigned int)&board);
  for (round = 1; round <= 3; round++) {
    unsigned int sum = 0;
    while (board.flag != 2 * round - 1) {
    }
    for (i = 0; i < 30; i++) sum += board.numbers[i];
    board.numbers[30] = sum;
    board.flag = 2 * round;
  }
  return 0;
}
