#define N 64  /* rows and columns */
#define TILE 4 /* 16 bytes of floats, the least that a list moves well */

struct matrices {
  unsigned long long from, to;
} __attribute__((aligned(16)));
