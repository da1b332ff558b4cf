/* Two functions that share one place in the local store; the linker's overlay manager fetches them by turns.
 */
#include <stdio.h>

__attribute__((section("overlay.one"), noinline)) int one(int x) {
  return x + 1;
}
__attribute__((section("overlay.two"), noinline)) int two(int x) {
  return 10 * x;
}

int main(void) {
  int sum = 0;
  for (int i = 0; i < 3; ++i) sum += one(i) + two(i);
  printf("sum %d\n", sum);
  return sum;
}
