#define TELLERS 4
#define ACCOUNTS 16
#define TRANSFERS 60

typedef struct {
  int balance[ACCOUNTS];
  int mutex __attribute__((aligned(128)));
  int done __attribute__((aligned(128)));
  int total __attribute__((aligned(128)));
} bank_t __attribute__((aligned(128)));
