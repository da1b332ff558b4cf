/* Four blocks of XTEA at once: a and b have the halves of each. */
#include <spu_intrinsics.h>

void encipher(vec_uint4 *a, vec_uint4 *b, const unsigned int key[4], int rounds) {
  unsigned int sum = 0;
  while (rounds-- > 0) {
    *a = spu_add(*a, spu_xor(spu_add(spu_xor(spu_sl(*b, 4), spu_rlmask(*b, -5)), *b), spu_splats(sum + key[sum & 3])));
    sum += 0x9e3779b9;
    *b = spu_add(*b, spu_xor(spu_add(spu_xor(spu_sl(*a, 4), spu_rlmask(*a, -5)), *a), spu_splats(sum + key[sum >> 11 & 3])));
  }
}
