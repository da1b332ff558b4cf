#include <spu_mfcio.h>

extern unsigned char in[4096], out[4096];

void transfer(void *ls, unsigned long long ea, unsigned int command);
