#include "queue.h"

int collatz_steps(unsigned int number) {
  int steps = 0;
  while (number != 1) {
    number = number % 2 != 0 ? 3 * number + 1 : number / 2;
    steps++;
  }
  return steps;
}
