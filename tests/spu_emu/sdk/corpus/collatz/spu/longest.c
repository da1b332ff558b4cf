#include <spu_intrinsics.h>
#include <stdio.h>

/* Unoptimised, with a stack frame for everything and output by the SPU's own printf. */
static unsigned int steps(unsigned long long n) {
  unsigned int count = 0;
  while (n != 1) {
    n = n % 2 ? 3 * n + 1 : n / 2;
    count++;
  }
  return count;
}

int main(unsigned long long spe, unsigned long long from, unsigned long long to) {
  unsigned long long n, best = from;
  (void)spe;
  for (n = from; n <= to; n++) {
    if (steps(n) > steps(best)) best = n;
  }
  printf("%llu to %llu: %llu takes %u steps\n", from, to, best, steps(best));
  return 0;
}
