// Shifts and rotates of halfwords and words, element by element: spu_sl, spu_sr, spu_sra, spu_rl,
// spu_rlmask(a).
//
// Counts are taken modulo twice the lane's bits (rotates: modulo its bits); from the lane's bits on, a shift
// leaves zeros or copies of the sign. spu_rlmask and spu_rlmaska shift right by the negated count.
#ifndef SPU_EMU_INTRINSICS_SHIFT_H
#define SPU_EMU_INTRINSICS_SHIFT_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

template <typename V>
constexpr unsigned int lane_bits = 8 * lane_bytes<V>;

// Shifts every lane by one count below 2 * lane_bits.
template <typename V>
SPU_EMU_INLINE V shift_left(V a, unsigned int count) {
  const __m128i n = _mm_cvtsi32_si128(static_cast<int>(count));
  return (V)(lane_bytes<V> == 2 ? _mm_sll_epi16((__m128i)a, n) : _mm_sll_epi32((__m128i)a, n));
}

template <typename V>
SPU_EMU_INLINE V shift_right(V a, unsigned int count) {
  const __m128i n = _mm_cvtsi32_si128(static_cast<int>(count));
  return (V)(lane_bytes<V> == 2 ? _mm_srl_epi16((__m128i)a, n) : _mm_srl_epi32((__m128i)a, n));
}

template <typename V>
SPU_EMU_INLINE V shift_right_signed(V a, unsigned int count) {
  const __m128i n = _mm_cvtsi32_si128(static_cast<int>(count));
  return (V)(lane_bytes<V> == 2 ? _mm_sra_epi16((__m128i)a, n) : _mm_sra_epi32((__m128i)a, n));
}

// The same with a count per lane, each below 2 * lane_bits. C++ leaves counts past the lane undefined, hence
// the mask and the select.
template <typename V>
SPU_EMU_INLINE V shift_left(V a, Unsigned<V> count) {
  using U = Unsigned<V>;
#ifdef __AVX2__
  if constexpr (lane_bytes<V> == 4) return (V)_mm_sllv_epi32((__m128i)a, (__m128i)count);
#endif
  constexpr auto limit = static_cast<Element<U>>(lane_bits<V>);
  return (V)(((U)a << (count & splat<U>(limit - 1))) & (U)(count < splat<U>(limit)));
}

template <typename V>
SPU_EMU_INLINE V shift_right(V a, Unsigned<V> count) {
  using U = Unsigned<V>;
#ifdef __AVX2__
  if constexpr (lane_bytes<V> == 4) return (V)_mm_srlv_epi32((__m128i)a, (__m128i)count);
#endif
  constexpr auto limit = static_cast<Element<U>>(lane_bits<V>);
  return (V)(((U)a >> (count & splat<U>(limit - 1))) & (U)(count < splat<U>(limit)));
}

template <typename V>
SPU_EMU_INLINE V shift_right_signed(V a, Unsigned<V> count) {
  using S = Signed<V>;
#ifdef __AVX2__
  if constexpr (lane_bytes<V> == 4) return (V)_mm_srav_epi32((__m128i)a, (__m128i)count);
#endif
  constexpr auto last = static_cast<Element<Unsigned<V>>>(lane_bits<V> - 1);
  const Unsigned<V> past = (Unsigned<V>)(count > splat<Unsigned<V>>(last));
  const Unsigned<V> clamped = (count & ~past) | (splat<Unsigned<V>>(last) & past);
  return (V)((S)a >> (S)clamped);
}

template <typename V>
SPU_EMU_INLINE Unsigned<V> shift_counts(Unsigned<V> count) {
  return count & splat<Unsigned<V>>(static_cast<Element<Unsigned<V>>>(2 * lane_bits<V> - 1));
}

template <typename V>
SPU_EMU_INLINE Unsigned<V> negated_counts(Signed<V> count) {
  return shift_counts<V>(Unsigned<V>{} - (Unsigned<V>)count);
}

template <typename V>
SPU_EMU_INLINE unsigned int shift_count(unsigned int count) {
  return count & (2 * lane_bits<V> - 1);
}

template <typename V>
SPU_EMU_INLINE unsigned int negated_count(int count) {
  return shift_count<V>(0U - static_cast<unsigned int>(count));
}

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sl(V a, spu_emu::detail::Unsigned<V> count) {
  return spu_emu::detail::shift_left(a, spu_emu::detail::shift_counts<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sl(V a, unsigned int count) {
  return spu_emu::detail::shift_left(a, spu_emu::detail::shift_count<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sr(V a, spu_emu::detail::Unsigned<V> count) {
  return spu_emu::detail::shift_right(a, spu_emu::detail::shift_counts<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sr(V a, unsigned int count) {
  return spu_emu::detail::shift_right(a, spu_emu::detail::shift_count<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sra(V a, spu_emu::detail::Unsigned<V> count) {
  return spu_emu::detail::shift_right_signed(a, spu_emu::detail::shift_counts<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_sra(V a, unsigned int count) {
  return spu_emu::detail::shift_right_signed(a, spu_emu::detail::shift_count<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rlmask(V a, spu_emu::detail::Signed<V> count) {
  return spu_emu::detail::shift_right(a, spu_emu::detail::negated_counts<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rlmask(V a, int count) {
  return spu_emu::detail::shift_right(a, spu_emu::detail::negated_count<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rlmaska(V a, spu_emu::detail::Signed<V> count) {
  return spu_emu::detail::shift_right_signed(a, spu_emu::detail::negated_counts<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rlmaska(V a, int count) {
  return spu_emu::detail::shift_right_signed(a, spu_emu::detail::negated_count<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rl(V a, spu_emu::detail::Signed<V> count) {
  namespace d = spu_emu::detail;
  using U = d::Unsigned<V>;
  constexpr auto last = static_cast<d::Element<U>>(d::lane_bits<V> - 1);
  const U left = (U)count & d::splat<U>(last);
  const U right = (U{} - left) & d::splat<U>(last);
  return (V)(((U)a << left) | ((U)a >> right));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 2, 4> spu_rl(V a, int count) {
  namespace d = spu_emu::detail;
  const unsigned int left = static_cast<unsigned int>(count) & (d::lane_bits<V> - 1);
  using U = d::Unsigned<V>;
  return (V)((U)d::shift_left(a, left) | (U)d::shift_right(a, d::lane_bits<V> - left));
}

#endif
