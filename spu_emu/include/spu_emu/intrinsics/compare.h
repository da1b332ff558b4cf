// Integer compares: spu_cmpeq and spu_cmpgt give all ones or zero per lane, in the unsigned type of that
// width.
#ifndef SPU_EMU_INTRINSICS_COMPARE_H
#define SPU_EMU_INTRINSICS_COMPARE_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

template <int Width>
SPU_EMU_INLINE __m128i lanes_equal(__m128i a, __m128i b) {
  if constexpr (Width == 1)
    return _mm_cmpeq_epi8(a, b);
  else if constexpr (Width == 2)
    return _mm_cmpeq_epi16(a, b);
  else
    return _mm_cmpeq_epi32(a, b);
}

template <int Width>
SPU_EMU_INLINE __m128i lanes_greater(__m128i a, __m128i b) {
  if constexpr (Width == 1)
    return _mm_cmpgt_epi8(a, b);
  else if constexpr (Width == 2)
    return _mm_cmpgt_epi16(a, b);
  else
    return _mm_cmpgt_epi32(a, b);
}

// SSE compares signed lanes only; flipping both sign bits makes that compare an unsigned one.
template <typename V>
SPU_EMU_INLINE __m128i order_as_signed(V v) {
  if constexpr (std::is_signed_v<Element<V>>) {
    return (__m128i)v;
  } else {
    constexpr auto flip = static_cast<Element<V>>(Element<V>{1} << (8 * lane_bytes<V> - 1));
    return _mm_xor_si128((__m128i)v, (__m128i)splat<V>(flip));
  }
}

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, spu_emu::detail::Unsigned<V>, 1, 2, 4> spu_cmpeq(V a, V b) {
  namespace d = spu_emu::detail;
  return (d::Unsigned<V>)d::lanes_equal<d::lane_bytes<V>>((__m128i)a, (__m128i)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, spu_emu::detail::Unsigned<V>, 1, 2, 4> spu_cmpeq(
    V a, spu_emu::detail::Element<V> b) {
  return spu_cmpeq(a, spu_emu::detail::splat<V>(b));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, spu_emu::detail::Unsigned<V>, 1, 2, 4> spu_cmpgt(V a, V b) {
  namespace d = spu_emu::detail;
  return (d::Unsigned<V>)d::lanes_greater<d::lane_bytes<V>>(d::order_as_signed(a), d::order_as_signed(b));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, spu_emu::detail::Unsigned<V>, 1, 2, 4> spu_cmpgt(
    V a, spu_emu::detail::Element<V> b) {
  return spu_cmpgt(a, spu_emu::detail::splat<V>(b));
}

#endif
