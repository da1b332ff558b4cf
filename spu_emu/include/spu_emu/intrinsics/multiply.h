// Products of halfwords into words: even (left) halves, odd (right) halves, and the pieces of a 32-bit
// product.
#ifndef SPU_EMU_INTRINSICS_MULTIPLY_H
#define SPU_EMU_INTRINSICS_MULTIPLY_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

// Element 2i of the halfwords in the low half of host word i, element 2i + 1 in its high half. pmaddwd adds
// both products, so one factor keeps only the half that counts.
SPU_EMU_INLINE __m128i only_even(__m128i halves) {
  return _mm_blend_epi16(halves, _mm_setzero_si128(), 0xaa);
}

SPU_EMU_INLINE __m128i only_odd(__m128i halves) {
  return _mm_blend_epi16(halves, _mm_setzero_si128(), 0x55);
}

// Unsigned products fit a word exactly: 32-bit multiply of zero-extended halves.
SPU_EMU_INLINE vec_uint4 even_halves(vec_ushort8 v) {
  return (vec_uint4)(is_big_endian ? _mm_srli_epi32((__m128i)v, 16) : only_even((__m128i)v));
}

SPU_EMU_INLINE vec_uint4 odd_halves(vec_ushort8 v) {
  return (vec_uint4)(is_big_endian ? only_odd((__m128i)v) : _mm_srli_epi32((__m128i)v, 16));
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE vec_int4 spu_mule(vec_short8 a, vec_short8 b) {
  return (vec_int4)_mm_madd_epi16(spu_emu::detail::only_even((__m128i)a), (__m128i)b);
}

SPU_EMU_INLINE vec_uint4 spu_mule(vec_ushort8 a, vec_ushort8 b) {
  return spu_emu::detail::even_halves(a) * spu_emu::detail::even_halves(b);
}

SPU_EMU_INLINE vec_int4 spu_mulo(vec_short8 a, vec_short8 b) {
  return (vec_int4)_mm_madd_epi16(spu_emu::detail::only_odd((__m128i)a), (__m128i)b);
}

SPU_EMU_INLINE vec_uint4 spu_mulo(vec_ushort8 a, vec_ushort8 b) {
  return spu_emu::detail::odd_halves(a) * spu_emu::detail::odd_halves(b);
}

SPU_EMU_INLINE vec_int4 spu_mulo(vec_short8 a, short b) {
  return spu_mulo(a, spu_emu::detail::splat<vec_short8>(b));
}

SPU_EMU_INLINE vec_uint4 spu_mulo(vec_ushort8 a, unsigned short b) {
  return spu_mulo(a, spu_emu::detail::splat<vec_ushort8>(b));
}

// c plus the product of the odd halves.
SPU_EMU_INLINE vec_int4 spu_madd(vec_short8 a, vec_short8 b, vec_int4 c) {
  return (vec_int4)((vec_uint4)spu_mulo(a, b) + (vec_uint4)c);
}

// c plus the product of the even halves.
SPU_EMU_INLINE vec_int4 spu_mhhadd(vec_short8 a, vec_short8 b, vec_int4 c) {
  return (vec_int4)((vec_uint4)spu_mule(a, b) + (vec_uint4)c);
}

SPU_EMU_INLINE vec_uint4 spu_mhhadd(vec_ushort8 a, vec_ushort8 b, vec_uint4 c) {
  return spu_mule(a, b) + c;
}

// a's even half times b's odd half, shifted left by 16: one cross term of a 32-bit product.
SPU_EMU_INLINE vec_int4 spu_mulh(vec_short8 a, vec_short8 b) {
  const __m128i b_odd_in_even_place = _mm_srli_epi32((__m128i)b, 16);
  const __m128i product = _mm_mullo_epi16((__m128i)a, b_odd_in_even_place);
  return (vec_int4)_mm_slli_epi32(product, 16);
}

// The left half of the odd product, sign-extended.
SPU_EMU_INLINE vec_int4 spu_mulsr(vec_short8 a, vec_short8 b) {
  return spu_mulo(a, b) >> 16;
}

#endif
