/* Formatted output and input through the host, with more arguments than registers hold. */
#include <stdio.h>
#include <string.h>

int main(unsigned long long speid, unsigned long long argp, unsigned long long envp) {
  char text[16];
  int number = 0;
  float single = 0;
  double exact = 0;
  (void)speid, (void)argp, (void)envp;
  printf("%d %s %c %5.2f %e %lld %x\n", -42, "text", 'x', 3.14159, 1e-10, 123456789012345LL, 0xbeefu);
  printf("%d %d %d %d %d %d %d %d %d %d\n", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
  printf(
      "%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d "
      "%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d "
      "%d "
      "%d %d %d %d %d\n",
      1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28,
      29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54,
      55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74);
  printf("%d\n", snprintf(text, sizeof text, "[%-6s|%06d]", "ab", -42));
  puts(text);
  printf("%d", sscanf("12 3.5 2.25 word", "%d %f %lf %15s", &number, &single, &exact, text));
  printf(" %d %g %g %s\n", number, (double)single, exact, text);
  fputs("put", stdout);
  putchar('\n');
  return 7;
}
