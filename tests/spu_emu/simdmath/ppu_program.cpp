// Evaluates functions of the SIMD math library on a PPU: reads the number of a function and of calls, then their arguments,
// and writes their results, all in this processor's byte order.
#include "simdmath/evaluate.h"

#include <cstdio>

int main() {
  using namespace simdmath_test;
  unsigned head[2];
  while (std::fread(head, sizeof head, 1, stdin) == 1) {
    if (head[0] >= sizeof evaluators / sizeof *evaluators) return 1;
    for (unsigned i = 0; i < head[1]; ++i) {
      Register in[kArguments];
      Register out[kResults] = {};
      if (std::fread(in, sizeof in, 1, stdin) != 1) return 2;
      evaluators[head[0]](in, out);
      if (std::fwrite(out, sizeof out, 1, stdout) != 1) return 3;
    }
  }
  return 0;
}
