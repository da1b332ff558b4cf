#define N 64
#define BLOCK 16

typedef struct {
  unsigned long long a, b, c;
  unsigned int row, pad;
} job_t __attribute__((aligned(16)));
