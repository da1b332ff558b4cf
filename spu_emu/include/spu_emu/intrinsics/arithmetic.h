// Integer sums: spu_add, spu_sub, their carries and borrows, and the byte sums, averages and differences.
//
// A carry or borrow vector holds 1 or 0 per word; where one is an input only its lowest bit counts.
// A borrow bit is 1 when nothing was borrowed, as on the SPU.
#ifndef SPU_EMU_INTRINSICS_ARITHMETIC_H
#define SPU_EMU_INTRINSICS_ARITHMETIC_H

#include "spu_emu/intrinsics/traits.h"

// Computed on unsigned lanes, so that overflow wraps.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_add(V a, V b) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)((U)a + (U)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_add(V a, spu_emu::detail::Element<V> b) {
  return spu_add(a, spu_emu::detail::splat<V>(b));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sub(V a, V b) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)((U)a - (U)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sub(spu_emu::detail::Element<V> a, V b) {
  return spu_sub(spu_emu::detail::splat<V>(a), b);
}

namespace spu_emu::detail {

// All ones per word where a > b, both unsigned.
SPU_EMU_INLINE vec_uint4 above(vec_uint4 a, vec_uint4 b) {
  const __m128i flip = _mm_set1_epi32(INT32_MIN);
  return (vec_uint4)_mm_cmpgt_epi32(_mm_xor_si128((__m128i)a, flip), _mm_xor_si128((__m128i)b, flip));
}

SPU_EMU_INLINE vec_uint4 lowest_bit(vec_uint4 v) {
  return v & splat<vec_uint4>(1);
}

// The carry out of a + b + carry, as 0 or 1 per word.
SPU_EMU_INLINE vec_uint4 carry_out(vec_uint4 a, vec_uint4 b, vec_uint4 carry) {
  const vec_uint4 sum = a + b;
  const vec_uint4 from_sum = above(a, sum);
  const vec_uint4 from_carry = above(sum, sum + carry);
  return (from_sum | from_carry) & splat<vec_uint4>(1);
}

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_addx(V a, V b, V carry) {
  return (V)((vec_uint4)a + (vec_uint4)b + spu_emu::detail::lowest_bit((vec_uint4)carry));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_subx(V a, V b, V borrow) {
  return spu_addx(a, (V) ~(vec_uint4)b, borrow);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_gencx(V a, V b, V carry) {
  return (V)spu_emu::detail::carry_out((vec_uint4)a, (vec_uint4)b,
                                       spu_emu::detail::lowest_bit((vec_uint4)carry));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_genc(V a, V b) {
  const vec_uint4 sum = (vec_uint4)a + (vec_uint4)b;
  return (V)(spu_emu::detail::above((vec_uint4)a, sum) & spu_emu::detail::splat<vec_uint4>(1));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_genbx(V a, V b, V borrow) {
  return spu_gencx(a, (V) ~(vec_uint4)b, borrow);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_genb(V a, V b) {
  const vec_uint4 borrowed = spu_emu::detail::above((vec_uint4)b, (vec_uint4)a);
  return (V)(~borrowed & spu_emu::detail::splat<vec_uint4>(1));
}

SPU_EMU_INLINE vec_uchar16 spu_avg(vec_uchar16 a, vec_uchar16 b) {
  return (vec_uchar16)_mm_avg_epu8((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_uchar16 spu_absd(vec_uchar16 a, vec_uchar16 b) {
  const __m128i x = (__m128i)a;
  const __m128i y = (__m128i)b;
  return (vec_uchar16)_mm_or_si128(_mm_subs_epu8(x, y), _mm_subs_epu8(y, x));
}

// Per word: the sum of b's four bytes in the left half, of a's in the right half.
SPU_EMU_INLINE vec_ushort8 spu_sumb(vec_uchar16 a, vec_uchar16 b) {
  const __m128i ones = _mm_set1_epi8(1);
  const __m128i pairs_a = _mm_maddubs_epi16((__m128i)a, ones);
  const __m128i pairs_b = _mm_maddubs_epi16((__m128i)b, ones);
  const __m128i sums = _mm_hadd_epi16(pairs_b, pairs_a);
  return (vec_ushort8)_mm_unpacklo_epi16(sums, _mm_unpackhi_epi64(sums, sums));
}

#endif
