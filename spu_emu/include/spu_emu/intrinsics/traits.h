// What the intrinsics know about each vector type: its element, its companion types, its name as __m128i.
#ifndef SPU_EMU_INTRINSICS_TRAITS_H
#define SPU_EMU_INTRINSICS_TRAITS_H

#ifdef __SSE4_1__
#include <smmintrin.h>
#else
#include "spu_emu/intrinsics/generic_floats.h"
#include "spu_emu/intrinsics/generic_shuffles.h"
// The compares that need no mode of the processor.
#ifndef SPU_EMU_PRECISE
#define SPU_EMU_PRECISE 1
#endif
#endif
#if defined(__AVX2__) || defined(__FMA__)
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "vec_types.h"

// Every intrinsic is forced inline: they are called with compile-time counts and cost one or two
// instructions.
#define SPU_EMU_INLINE inline __attribute__((always_inline))

namespace spu_emu::detail {

// On a big-endian processor lanes of every width lie in memory as on the SPU.
constexpr bool is_big_endian = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

// Element: the scalar of one lane. Unsigned/Signed: the integer vectors with lanes of the same width, which
// are the types of masks and of shift counts.
template <typename V>
struct VecTraits;

template <typename V, typename ElementT, typename UnsignedT, typename SignedT>
struct VecTraitsOf {
  using Element = ElementT;
  using Unsigned = UnsignedT;
  using Signed = SignedT;
  static constexpr int count = static_cast<int>(16 / sizeof(ElementT));
};

template <>
struct VecTraits<vec_uchar16> : VecTraitsOf<vec_uchar16, unsigned char, vec_uchar16, vec_char16> {};
template <>
struct VecTraits<vec_char16> : VecTraitsOf<vec_char16, signed char, vec_uchar16, vec_char16> {};
template <>
struct VecTraits<vec_ushort8> : VecTraitsOf<vec_ushort8, unsigned short, vec_ushort8, vec_short8> {};
template <>
struct VecTraits<vec_short8> : VecTraitsOf<vec_short8, short, vec_ushort8, vec_short8> {};
template <>
struct VecTraits<vec_uint4> : VecTraitsOf<vec_uint4, unsigned int, vec_uint4, vec_int4> {};
template <>
struct VecTraits<vec_int4> : VecTraitsOf<vec_int4, int, vec_uint4, vec_int4> {};
template <>
struct VecTraits<vec_ullong2> : VecTraitsOf<vec_ullong2, unsigned long long, vec_ullong2, vec_llong2> {};
template <>
struct VecTraits<vec_llong2> : VecTraitsOf<vec_llong2, long long, vec_ullong2, vec_llong2> {};
template <>
struct VecTraits<vec_float4> : VecTraitsOf<vec_float4, float, vec_uint4, vec_int4> {};
template <>
struct VecTraits<vec_double2> : VecTraitsOf<vec_double2, double, vec_ullong2, vec_llong2> {};

template <typename V>
using Element = typename VecTraits<V>::Element;
template <typename V>
using Unsigned = typename VecTraits<V>::Unsigned;
template <typename V>
using Signed = typename VecTraits<V>::Signed;

template <typename V>
constexpr int lane_bytes = static_cast<int>(sizeof(Element<V>));

// Result type R, for vectors whose elements are integers of one of the widths named (0: any width).
template <typename V, int... Widths>
constexpr bool is_integer_of = std::is_integral_v<Element<V>> &&
                               (sizeof...(Widths) == 0 || ((lane_bytes<V> == Widths) || ...));

template <typename V, typename R, int... Widths>
using IfInteger = std::enable_if_t<is_integer_of<V, Widths...>, R>;

template <typename V>
SPU_EMU_INLINE __m128i bits(V v) {
  return (__m128i)v;
}

template <typename V>
SPU_EMU_INLINE V from_bits(__m128i b) {
  return (V)b;
}

// All lanes equal to s.
template <typename V>
SPU_EMU_INLINE V splat(Element<V> s) {
  if constexpr (lane_bytes<V> == 8)
    return V{s, s};
  else if constexpr (lane_bytes<V> == 4)
    return V{s, s, s, s};
  else if constexpr (lane_bytes<V> == 2)
    return V{s, s, s, s, s, s, s, s};
  else
    return V{s, s, s, s, s, s, s, s, s, s, s, s, s, s, s, s};
}

}  // namespace spu_emu::detail

#endif
