// Four generators of xorshift in one register; a dart is a pair of 16 bits.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

int main(unsigned long long spe, unsigned long long seed, unsigned long long rounds) {
  vec_uint4 state = spu_add(spu_splats((unsigned int)seed * 7919u), ((vec_uint4){1, 2, 3, 4}));
  vec_uint4 inside = spu_splats(0u);
  unsigned int i;
  (void)spe;
  for (i = 0; i < rounds; i++) {
    state = spu_xor(state, spu_sl(state, 13));
    state = spu_xor(state, spu_rlmask(state, -17));
    state = spu_xor(state, spu_sl(state, 5));
    const vec_ushort8 x = (vec_ushort8)spu_rlmask(state, -17), y = (vec_ushort8)spu_and(state, 0x7fff);
    const vec_uint4 square = spu_add(spu_mulo(x, x), spu_mulo(y, y));
    inside = spu_sub(inside, spu_cmpgt(spu_splats(0x40000000u), square));
  }
  spu_write_out_mbox(spu_extract(inside, 0) + spu_extract(inside, 1) + spu_extract(inside, 2) + spu_extract(inside, 3));
  return 0;
}
