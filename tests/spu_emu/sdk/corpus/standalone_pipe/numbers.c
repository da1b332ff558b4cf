#include <stdio.h>
#include <stdlib.h>

int main(int argc, char *argv[]) {
  int i, to = argc > 1 ? atoi(argv[1]) : 10;
  for (i = 2; i <= to; i++) printf("%d\n", i);
  return ferror(stdout) != 0;
}
