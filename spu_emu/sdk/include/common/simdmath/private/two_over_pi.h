/* Any angle taken to quarters of a turn, in integers. */
#ifndef SPU_EMU_SIMDMATH_TWO_OVER_PI_H
#define SPU_EMU_SIMDMATH_TWO_OVER_PI_H

/* An angle in quarters of a turn: quarter + (negative ? -1 : 1) * (high + low / 2^64) * 2^exponent, the last part at most
 * a half. The highest bit of high is set. */
typedef struct sm_quarters {
  unsigned int quarter;
  int negative;
  int exponent;
  unsigned long long high;
  unsigned long long low;
} sm_quarters;

enum { sm_window_words = 7 };

/* The words of 2 / pi from the one at which an angle of so many binary digits begins to matter. */
static inline const unsigned int* sm_two_over_pi(int first) {
  static const unsigned int digits[] = {
      0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u,
      0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu, 0xe88235f5u, 0x2ebb4484u,
      0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu, 0x1ff897ffu, 0xde05980fu,
      0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u, 0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu,
      0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u, 0xfc7b6babu, 0xf0cfbc20u, 0x9af4361du};
  return digits + first;
}

/* product, lowest word first, = significand * the window of 2 / pi; what is above its words is multiples of a turn. */
static inline void sm_times_window(unsigned long long significand, const unsigned int* window, unsigned int* product) {
  const unsigned int parts[2] = {(unsigned int)significand, (unsigned int)(significand >> 32)};
  int i, j;
  for (i = 0; i < sm_window_words + 2; ++i) product[i] = 0;
  for (j = 0; j < 2; ++j) {
    unsigned long long carry = 0;
    for (i = 0; i < sm_window_words; ++i) {
      carry += (unsigned long long)parts[j] * window[sm_window_words - 1 - i] + product[i + j];
      product[i + j] = (unsigned int)carry;
      carry >>= 32;
    }
    product[sm_window_words + j] += (unsigned int)carry;
  }
}

/* 64 bits of the words, lowest first, below the bit `top`. */
static inline unsigned long long sm_bits_below(const unsigned int* words, int top) {
  unsigned long long bits = 0;
  int i;
  for (i = 1; i <= 64; ++i) {
    const int at = top - i;
    bits = bits << 1 | (at >= 0 ? words[at >> 5] >> (at & 31) & 1u : 0u);
  }
  return bits;
}

/* significand * 2^power, power at least 0, in quarters of a turn. */
static inline sm_quarters sm_to_quarters(unsigned long long significand, int power) {
  const int first = power < 2 ? 0 : (power - 2) >> 5;
  const int point = 32 * (first + sm_window_words) - power;
  unsigned int product[sm_window_words + 2];
  sm_quarters result;
  int top, i;
  sm_times_window(significand, sm_two_over_pi(first), product);
  result.quarter = (unsigned int)(sm_bits_below(product, point + 2) >> 62);
  result.negative = (int)(product[(point - 1) >> 5] >> ((point - 1) & 31) & 1u);
  if (result.negative) {
    /* One quarter more, less the complement, whose last bit does not matter. */
    result.quarter = (result.quarter + 1) & 3u;
    for (i = 0; i < sm_window_words + 2; ++i) product[i] = ~product[i];
  }
  top = point;
  while (top > 128 && (product[(top - 1) >> 5] >> ((top - 1) & 31) & 1u) == 0) --top;
  result.high = sm_bits_below(product, top);
  result.low = sm_bits_below(product, top - 64);
  result.exponent = top - point - 64;
  return result;
}

#endif
