#include <spu_mfcio.h>

static unsigned int primes[1024] __attribute__((aligned(128)));
static bool composite[8192];

int main(unsigned long long, unsigned long long result, unsigned long long) {
  unsigned int count = 0;
  for (unsigned int i = 2; i < 8192 && count < 1024; ++i) {
    if (composite[i]) continue;
    primes[count++] = i;
    for (unsigned int k = i * i; k < 8192; k += i) composite[k] = true;
  }
  mfc_put(primes, result, sizeof primes, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  spu_write_out_mbox(count);
  return 0;
}
