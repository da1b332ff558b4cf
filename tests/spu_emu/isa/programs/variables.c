// A program for the debugger: variables of every kind, in structures, arrays and blocks, behind pointers.
#include <spu_intrinsics.h>

enum colour { red, green = 5, blue };

struct item {
  short weight;
  enum colour colour;
  const char* name;
  struct item* next;
};

static struct item second = {-7, blue, "second", 0};
static struct item first = {300, green, "first", &second};
static double ratios[2][3] = {{0.5, 1, 1.5}, {2, 2.5, 3}};
static vec_float4 direction = {1, 2, -3, 0.25f};
static char text[8] = "scale";
unsigned long long large = 1ULL << 40;

__attribute__((noinline)) int weigh(struct item* list, unsigned char limit) {
  int sum = 0;
  while (list) {
    int weight = list->weight;
    if (weight < limit) weight *= 2;
    sum += weight;
    list = list->next;
  }
  return sum;
}

int main(void) {
  int sum = weigh(&first, 10);
  return sum == 286 ? (int)ratios[1][0] + text[0] - 's' + (int)large : sum & 127;
}
