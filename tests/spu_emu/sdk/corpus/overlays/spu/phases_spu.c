#include "phases.h"

unsigned int values[COUNT] __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long ea, unsigned long long unused) {
  unsigned int round, code = 0;
  (void)spe;
  (void)unused;
  for (round = 0; round < 3; round++) {
    read_values(ea);
    sort_values();
    code += report_values(ea);
  }
  return (int)code;
}
