#include <stdio.h>

int main(void) {
  int n, d, found = 0;
  while (scanf("%d", &n) == 1) {
    for (d = 2; d * d <= n && n % d != 0; d++) {
    }
    if (d * d > n) printf("%s%d", found++ ? " " : "", n);
  }
  fprintf(stdout, "\n%d primes\n", found);
  return 0;
}
