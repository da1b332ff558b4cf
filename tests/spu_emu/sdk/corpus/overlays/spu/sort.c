#include "phases.h"

void sort_values(void) {
  int i, j;
  for (i = 1; i < COUNT; i++) {
    unsigned int value = values[i];
    for (j = i; j > 0 && values[j - 1] > value; j--) values[j] = values[j - 1];
    values[j] = value;
  }
}
