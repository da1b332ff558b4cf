// Bitwise operations on all vector types: spu_and, spu_or, spu_xor, their complements, spu_sel and spu_orx.
#ifndef SPU_EMU_INTRINSICS_LOGICAL_H
#define SPU_EMU_INTRINSICS_LOGICAL_H

#include "spu_emu/intrinsics/traits.h"

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_and(V a, V b) {
  return (V)_mm_and_si128((__m128i)a, (__m128i)b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_or(V a, V b) {
  return (V)_mm_or_si128((__m128i)a, (__m128i)b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_xor(V a, V b) {
  return (V)_mm_xor_si128((__m128i)a, (__m128i)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> spu_and(V a, spu_emu::detail::Element<V> b) {
  return spu_and(a, spu_emu::detail::splat<V>(b));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> spu_or(V a, spu_emu::detail::Element<V> b) {
  return spu_or(a, spu_emu::detail::splat<V>(b));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> spu_xor(V a, spu_emu::detail::Element<V> b) {
  return spu_xor(a, spu_emu::detail::splat<V>(b));
}

namespace spu_emu::detail {

template <typename V>
SPU_EMU_INLINE V complement(V a) {
  return (V)_mm_xor_si128((__m128i)a, _mm_set1_epi32(-1));
}

}  // namespace spu_emu::detail

// a and not b.
template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_andc(V a, V b) {
  return (V)_mm_andnot_si128((__m128i)b, (__m128i)a);
}

// a or not b.
template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_orc(V a, V b) {
  return spu_or(a, spu_emu::detail::complement(b));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_eqv(V a, V b) {
  return spu_emu::detail::complement(spu_xor(a, b));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_nand(V a, V b) {
  return spu_emu::detail::complement(spu_and(a, b));
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V spu_nor(V a, V b) {
  return spu_emu::detail::complement(spu_or(a, b));
}

// Bit by bit: b where the mask has a one, a elsewhere.
template <typename V>
SPU_EMU_INLINE V spu_sel(V a, V b, spu_emu::detail::Unsigned<V> mask) {
  const __m128i m = (__m128i)mask;
  return (V)_mm_or_si128(_mm_andnot_si128(m, (__m128i)a), _mm_and_si128(m, (__m128i)b));
}

// The OR of all words in element 0, zero elsewhere.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 4> spu_orx(V a) {
  __m128i x = (__m128i)a;
  x = _mm_or_si128(x, _mm_shuffle_epi32(x, _MM_SHUFFLE(1, 0, 3, 2)));
  x = _mm_or_si128(x, _mm_shuffle_epi32(x, _MM_SHUFFLE(2, 3, 0, 1)));
  return (V)_mm_and_si128(x, _mm_setr_epi32(-1, 0, 0, 0));
}

#endif
