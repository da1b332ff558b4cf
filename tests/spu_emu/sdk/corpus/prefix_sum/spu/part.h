#define PARTS 4
#define WORDS 256

struct part {
  unsigned long long words;
  unsigned long long next_signal; /* the next SPE's signal registers, or 0 */
} __attribute__((aligned(16)));
