/* What both sides lay out alike: bit fields, a union, halfwords, a double and a 64-bit number. */
typedef struct {
  unsigned int kind : 4, flags : 12, serial : 16;
  union {
    float number;
    unsigned char bytes[4];
  } u;
  short halves[4];
  double exact;
  unsigned long long big;
} record_t __attribute__((aligned(128)));
