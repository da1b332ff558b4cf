#include <stdio.h>

int main(unsigned long long id, unsigned long long argp, unsigned long long envp) {
  (void)envp;
  printf("SPE %u of %u: %s\n", (unsigned int)argp & 0xff, (unsigned int)argp >> 8, id != 0 ? "hello" : "nobody's");
  return (int)(argp & 0xff);
}
