#define SPES 4
#define CHUNK 16384 /* the largest transfer */
#define CHUNKS 8    /* for each SPE */

struct control {
  unsigned long long ea;
  unsigned int chunks;
  unsigned int result;
} __attribute__((aligned(16)));
