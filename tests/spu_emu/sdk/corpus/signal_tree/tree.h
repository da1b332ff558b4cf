#define NODES 7

/* Where the signal registers of each node are, for DMA: the tree is a heap, 0 is its root. */
typedef struct {
  unsigned long long signal1[NODES + 1];
  unsigned int node;
  unsigned int pad[3];
} __attribute__((aligned(128))) setup_t;
