#define MEMBERS 5
#define ROUNDS 3

struct link {
  unsigned long long next; /* the effective address of the next one's local store */
  unsigned int number;
  unsigned int fill;
} __attribute__((aligned(16)));
