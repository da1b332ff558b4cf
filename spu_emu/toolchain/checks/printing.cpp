// Prints through the C library, which asks the host side to do it.
#include <cstdio>

int main() {
  std::printf("%s %d %.2f\n", "spu", 23, 0.25);
  return 0;
}
