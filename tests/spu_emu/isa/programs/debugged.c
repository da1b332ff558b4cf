// A program for the debugger: lines, calls, a global that changes, a wait.
#include <spu_mfcio.h>

volatile int steps;
float mean[4] __attribute__((aligned(16)));

__attribute__((noinline)) int square(int n) {
  return n * n;
}

__attribute__((noinline)) int sum_to(int last) {
  int sum = 0;
  for (int i = 1; i <= last; ++i) {
    sum += square(i);
    steps = i;
  }
  return sum;
}

int main(void) {
  int sum = sum_to(3);
  mean[0] = (float)sum / 3;
  spu_write_out_mbox(sum);
  mfc_get(mean, 0, 100, 5, 0, 0);
  return sum;
}
