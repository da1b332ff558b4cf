// vmx2spu.h: integer and float sums, saturation, averages, absolute values, minimum and maximum.
//
// Saturation leaves no trace in a status register. Minimum and maximum compare and select: of two equal
// floats, and zeros of either sign are equal, vec_min takes the first operand and vec_max the second.
#ifndef SPU_EMU_INTRINSICS_VMX_ARITHMETIC_H
#define SPU_EMU_INTRINSICS_VMX_ARITHMETIC_H

#include "spu_emu/intrinsics/arithmetic.h"
#include "spu_emu/intrinsics/compare.h"
#include "spu_emu/intrinsics/float.h"
#include "spu_emu/intrinsics/float_compare.h"
#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/vmx_types.h"

SPU_EMU_INLINE vec_float4 vec_add(vec_float4 a, vec_float4 b) {
  return spu_add(a, b);
}

SPU_EMU_INLINE vec_float4 vec_sub(vec_float4 a, vec_float4 b) {
  return spu_sub(a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_add(V a, V b) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)(U)((U)a + (U)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_sub(V a, V b) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)(U)((U)a - (U)b);
}

SPU_EMU_INLINE vec_uchar16 vec_adds(vec_uchar16 a, vec_uchar16 b) {
  return (vec_uchar16)_mm_adds_epu8((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_char16 vec_adds(vec_char16 a, vec_char16 b) {
  return (vec_char16)_mm_adds_epi8((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_ushort8 vec_adds(vec_ushort8 a, vec_ushort8 b) {
  return (vec_ushort8)_mm_adds_epu16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_short8 vec_adds(vec_short8 a, vec_short8 b) {
  return (vec_short8)_mm_adds_epi16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_uint4 vec_adds(vec_uint4 a, vec_uint4 b) {
  const vec_uint4 sum = a + b;
  return sum | spu_emu::detail::above(a, sum);
}

namespace spu_emu::detail {

// The signed word nearest to an overflown result: the largest, or for negative x the smallest.
SPU_EMU_INLINE vec_int4 word_limit(vec_int4 x) {
  return (vec_int4)((vec_uint4)(x >> 31) ^ splat<vec_uint4>(0x7fffffff));
}

// `value` but where `overflow` is negative, there the limit on x's side.
SPU_EMU_INLINE vec_int4 limit_words(vec_int4 value, vec_int4 overflow, vec_int4 x) {
  return spu_sel(value, word_limit(x), (vec_uint4)(overflow >> 31));
}

}  // namespace spu_emu::detail

// A sum overflows where both operands have the sign that it has not.
SPU_EMU_INLINE vec_int4 vec_adds(vec_int4 a, vec_int4 b) {
  const vec_int4 sum = spu_add(a, b);
  return spu_emu::detail::limit_words(sum, (a ^ sum) & (b ^ sum), a);
}

SPU_EMU_INLINE vec_uchar16 vec_subs(vec_uchar16 a, vec_uchar16 b) {
  return (vec_uchar16)_mm_subs_epu8((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_char16 vec_subs(vec_char16 a, vec_char16 b) {
  return (vec_char16)_mm_subs_epi8((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_ushort8 vec_subs(vec_ushort8 a, vec_ushort8 b) {
  return (vec_ushort8)_mm_subs_epu16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_short8 vec_subs(vec_short8 a, vec_short8 b) {
  return (vec_short8)_mm_subs_epi16((__m128i)a, (__m128i)b);
}

SPU_EMU_INLINE vec_uint4 vec_subs(vec_uint4 a, vec_uint4 b) {
  return (a - b) & ~spu_emu::detail::above(b, a);
}

SPU_EMU_INLINE vec_int4 vec_subs(vec_int4 a, vec_int4 b) {
  const vec_int4 difference = spu_sub(a, b);
  return spu_emu::detail::limit_words(difference, (a ^ b) & (a ^ difference), a);
}

// Wraps: the smallest number is its own absolute value.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfSigned<V> vec_abs(V a) {
  return (V)(spu_emu::detail::lane_bytes<V> == 1   ? _mm_abs_epi8((__m128i)a)
             : spu_emu::detail::lane_bytes<V> == 2 ? _mm_abs_epi16((__m128i)a)
                                                   : _mm_abs_epi32((__m128i)a));
}

SPU_EMU_INLINE vec_float4 vec_abs(vec_float4 a) {
  return spu_emu::detail::magnitude(a);
}

// Saturates: the smallest number becomes the largest.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfSigned<V> vec_abss(V a) {
  using U = spu_emu::detail::Unsigned<V>;
  const U magnitude = (U)vec_abs(a);
  const U overflown = (U)((V)magnitude < V{});
  return (V)(U)(magnitude + overflown);
}

// (a + b + 1) / 2 rounded down, without overflow: the bits that differ count half.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_avg(V a, V b) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)(U)((U)(a | b) - (U)((a ^ b) >> 1));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE V vec_max(V a, V b) {
  return spu_sel(b, a, spu_cmpgt(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE V vec_min(V a, V b) {
  return spu_sel(a, b, spu_cmpgt(a, b));
}

// With a boolean vector as one operand.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_add(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_add((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_add(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_add(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_sub(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_sub((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_sub(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_sub(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_adds(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_adds((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_adds(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_adds(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_subs(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_subs((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_subs(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_subs(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_max(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_max((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_max(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_max(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_min(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_min((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, V> vec_min(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_min(a, (V)b);
}

#endif
