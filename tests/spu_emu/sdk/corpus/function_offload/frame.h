#define FUNCTION_DOT 1
#define FUNCTION_POLYNOMIAL 2

#define STOP_NEXT 0x111 /* the SPE has done the call and waits for the next */

struct frame {
  unsigned int function;
  unsigned int count;
  float argument;
  float result;
  unsigned long long vectors[2];
} __attribute__((aligned(128)));
