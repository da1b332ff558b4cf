#define PLACES 28
#define ITEMS 90
#define EATERS 3

typedef struct {
  unsigned int lock; /* the host's, by libsync */
  unsigned int head, tail, fill;
  unsigned int items[PLACES];
} queue_t __attribute__((aligned(128)));
