#include "sha256.h"

/* The fractions of the cube roots of the first 64 primes are found here, not written down. */
static unsigned int fraction_of_cube_root(unsigned int n) {
  unsigned long long root = 0, bit;
  /* root^3 <= n * 2^96, root of 35 bits, in numbers of 128 bits made of two */
  for (bit = 1ull << 34; bit != 0; bit >>= 1) {
    const unsigned long long r = root | bit, low = r & 0xffffffffu, high = r >> 32;
    const unsigned long long ll = low * low, lh = low * high, hh = high * high;
    const unsigned long long square_low = ll + (lh << 33), carry = square_low < ll;
    const unsigned long long square_high = hh + (lh >> 31) + carry;
    const unsigned long long a = (square_low & 0xffffffffu) * low;
    const unsigned long long b = (square_low >> 32) * low + (a >> 32);
    const unsigned long long c = square_high * low + (b >> 32);
    const unsigned long long d = (square_low & 0xffffffffu) * high + (b & 0xffffffffu);
    const unsigned long long e = (square_low >> 32) * high + (d >> 32) + (c & 0xffffffffu);
    const unsigned long long f = square_high * high + (c >> 32) + (e >> 32);
    if (f < n) root = r;
  }
  return (unsigned int)root;
}

static int is_prime(unsigned int n) {
  unsigned int d;
  for (d = 2; d * d <= n; d++) {
    if (n % d == 0) return 0;
  }
  return n > 1;
}

static unsigned int k[64];

static void make_constants(void) {
  unsigned int i, n;
  for (i = 0, n = 2; i < 64; n++) {
    if (is_prime(n)) k[i++] = fraction_of_cube_root(n);
  }
}

static unsigned int ror(unsigned int x, int n) {
  return x >> n | x << (32 - n);
}

void sha256_block(unsigned int state[8], const unsigned int words[16]) {
  unsigned int w[64], v[8], i, j;
  if (k[0] == 0) make_constants();
  for (i = 0; i < 16; i++) w[i] = words[i];
  for (; i < 64; i++) {
    const unsigned int a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (ror(a, 7) ^ ror(a, 18) ^ a >> 3) + w[i - 7] + (ror(b, 17) ^ ror(b, 19) ^ b >> 10);
  }
  for (j = 0; j < 8; j++) v[j] = state[j];
  for (i = 0; i < 64; i++) {
    const unsigned int choice = (v[4] & v[5]) ^ (~v[4] & v[6]), most = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
    const unsigned int one = v[7] + (ror(v[4], 6) ^ ror(v[4], 11) ^ ror(v[4], 25)) + choice + k[i] + w[i];
    const unsigned int two = (ror(v[0], 2) ^ ror(v[0], 13) ^ ror(v[0], 22)) + most;
    for (j = 7; j > 0; j--) v[j] = v[j - 1];
    v[4] += one;
    v[0] = one + two;
  }
  for (j = 0; j < 8; j++) state[j] += v[j];
}
