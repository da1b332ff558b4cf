#include <math.h>

int check(const float *in, const float *out, float offset) {
  int i, wrong = 0;
  for (i = 0; i < COUNT; i++) {
    if (fabs(out[i] - (in[i] * 0.5 + offset)) > 1e-6) wrong++;
  }
  return wrong;
}
