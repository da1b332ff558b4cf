#include <math.h>

int main(void) {
  volatile float large = 3e38f;
  return large * large == HUGE_VALF && isinf(1 / 0.0) ? 42 : 1;
}
