#include <stdio.h>

float dot(const float *a, const float *b, unsigned int count);
float polynomial(float x, const float *coefficients, unsigned int count);
void end_of_calls(void);

static float a[1000] __attribute__((aligned(16)));
static float b[1000] __attribute__((aligned(16)));

int main(void) {
  static const float coefficients[4] __attribute__((aligned(16))) = {1, -2, 0.5, 3};
  int i;
  for (i = 0; i < 1000; i++) {
    a[i] = i % 10;
    b[i] = i % 4;
  }
  printf("dot %g\n", dot(a, b, 1000));
  printf("dot of the first hundred %g\n", dot(a, b, 100));
  printf("polynomial at 2: %g\n", polynomial(2, coefficients, 4));
  end_of_calls();
  return 0;
}
