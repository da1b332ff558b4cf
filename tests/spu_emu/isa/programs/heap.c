/* Takes all of the heap and tells its size in units of 4 KB. */
#include <stdlib.h>

int main(void) {
  int taken = 0;
  while (malloc(1024 - 16) != NULL) ++taken;
  return taken / 4;
}
