// vmx2spu.h: compares, and the predicates vec_all_ and vec_any_, which give 1 or 0.
//
// Nothing is unordered on an SPU, so "not greater" is "less or equal". The questions for NaNs look at the
// bits: exponent 255 is not numeric, and a NaN if its fraction is not zero. Only vec_all_nan is always 0.
#ifndef SPU_EMU_INTRINSICS_VMX_COMPARE_H
#define SPU_EMU_INTRINSICS_VMX_COMPARE_H

#include "spu_emu/intrinsics/compare.h"
#include "spu_emu/intrinsics/float_compare.h"
#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/vmx_types.h"

template <typename V>
SPU_EMU_INLINE auto vec_cmpeq(V a, V b) -> decltype(spu_cmpeq(a, b)) {
  return spu_cmpeq(a, b);
}

template <typename V>
SPU_EMU_INLINE auto vec_cmpgt(V a, V b) -> decltype(spu_cmpgt(a, b)) {
  return spu_cmpgt(a, b);
}

template <typename V>
SPU_EMU_INLINE auto vec_cmplt(V a, V b) -> decltype(spu_cmpgt(b, a)) {
  return spu_cmpgt(b, a);
}

SPU_EMU_INLINE vec_bint4 vec_cmpge(vec_float4 a, vec_float4 b) {
  return ~spu_cmpgt(b, a);
}

SPU_EMU_INLINE vec_bint4 vec_cmple(vec_float4 a, vec_float4 b) {
  return ~spu_cmpgt(a, b);
}

// Bounds: the leftmost bit where a > b, the next one where a < -b.
SPU_EMU_INLINE vec_int4 vec_cmpb(vec_float4 a, vec_float4 b) {
  const vec_float4 lower = (vec_float4)((vec_uint4)b ^ spu_emu::detail::splat<vec_uint4>(0x80000000U));
  const vec_uint4 above = spu_cmpgt(a, b) & spu_emu::detail::splat<vec_uint4>(0x80000000U);
  const vec_uint4 below = spu_cmpgt(lower, a) & spu_emu::detail::splat<vec_uint4>(0x40000000U);
  return (vec_int4)(above | below);
}

namespace spu_emu::detail {

template <typename V>
SPU_EMU_INLINE int all_set(V mask) {
  return _mm_movemask_epi8((__m128i)mask) == 0xffff ? 1 : 0;
}

template <typename V>
SPU_EMU_INLINE int any_set(V mask) {
  return _mm_movemask_epi8((__m128i)mask) != 0 ? 1 : 0;
}

}  // namespace spu_emu::detail

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_eq(V a, V b) {
  return spu_emu::detail::all_set(spu_cmpeq(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_ne(V a, V b) {
  return 1 - spu_emu::detail::any_set(spu_cmpeq(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_gt(V a, V b) {
  return spu_emu::detail::all_set(spu_cmpgt(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_lt(V a, V b) {
  return spu_emu::detail::all_set(spu_cmpgt(b, a));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_ge(V a, V b) {
  return 1 - spu_emu::detail::any_set(spu_cmpgt(b, a));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_all_le(V a, V b) {
  return 1 - spu_emu::detail::any_set(spu_cmpgt(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_eq(V a, V b) {
  return spu_emu::detail::any_set(spu_cmpeq(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_ne(V a, V b) {
  return 1 - spu_emu::detail::all_set(spu_cmpeq(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_gt(V a, V b) {
  return spu_emu::detail::any_set(spu_cmpgt(a, b));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_lt(V a, V b) {
  return spu_emu::detail::any_set(spu_cmpgt(b, a));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_ge(V a, V b) {
  return 1 - spu_emu::detail::all_set(spu_cmpgt(b, a));
}

template <typename V, typename = std::enable_if_t<spu_emu::detail::lane_bytes<V> <= 4>>
SPU_EMU_INLINE int vec_any_le(V a, V b) {
  return 1 - spu_emu::detail::all_set(spu_cmpgt(a, b));
}

// With a boolean vector as one operand.
template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_eq(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_eq((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_eq(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_eq(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_ne(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_ne((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_ne(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_ne(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_gt(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_gt((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_gt(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_gt(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_lt(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_lt((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_lt(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_lt(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_ge(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_ge((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_ge(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_ge(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_le(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_all_le((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_all_le(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_all_le(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_eq(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_eq((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_eq(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_eq(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_ne(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_ne((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_ne(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_ne(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_gt(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_gt((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_gt(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_gt(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_lt(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_lt((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_lt(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_lt(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_ge(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_ge((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_ge(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_ge(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_le(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_any_le((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixes<V, int> vec_any_le(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_any_le(a, (V)b);
}

SPU_EMU_INLINE int vec_all_nge(vec_float4 a, vec_float4 b) {
  return vec_all_lt(a, b);
}

SPU_EMU_INLINE int vec_all_ngt(vec_float4 a, vec_float4 b) {
  return vec_all_le(a, b);
}

SPU_EMU_INLINE int vec_all_nle(vec_float4 a, vec_float4 b) {
  return vec_all_gt(a, b);
}

SPU_EMU_INLINE int vec_all_nlt(vec_float4 a, vec_float4 b) {
  return vec_all_ge(a, b);
}

namespace spu_emu::detail {

SPU_EMU_INLINE vec_uint4 has_exponent_255(vec_float4 v) {
  const vec_uint4 exponent = splat<vec_uint4>(0x7f800000U);
  return spu_cmpeq((vec_uint4)v & exponent, exponent);
}

}  // namespace spu_emu::detail

SPU_EMU_INLINE int vec_all_nan(vec_float4) {
  return 0;
}

SPU_EMU_INLINE int vec_all_numeric(vec_float4 a) {
  return 1 - spu_emu::detail::any_set(spu_emu::detail::has_exponent_255(a));
}

SPU_EMU_INLINE int vec_any_nge(vec_float4 a, vec_float4 b) {
  return vec_any_lt(a, b);
}

SPU_EMU_INLINE int vec_any_ngt(vec_float4 a, vec_float4 b) {
  return vec_any_le(a, b);
}

SPU_EMU_INLINE int vec_any_nle(vec_float4 a, vec_float4 b) {
  return vec_any_gt(a, b);
}

SPU_EMU_INLINE int vec_any_nlt(vec_float4 a, vec_float4 b) {
  return vec_any_ge(a, b);
}

// As integers, the patterns of magnitudes are in order, and infinity's is the largest that is no NaN.
SPU_EMU_INLINE int vec_any_nan(vec_float4 a) {
  const vec_int4 size = (vec_int4)spu_emu::detail::magnitude(a);
  return spu_emu::detail::any_set(spu_cmpgt(size, 0x7f800000));
}

SPU_EMU_INLINE int vec_any_numeric(vec_float4 a) {
  return 1 - spu_emu::detail::all_set(spu_emu::detail::has_exponent_255(a));
}

// Any element outside the bounds -b to b. Nothing is within a bound whose sign bit is set, not even zero
// within -0; vec_cmpb finds zero within it.
SPU_EMU_INLINE int vec_any_out(vec_float4 a, vec_float4 b) {
  const vec_uint4 no_bound = (vec_uint4)((vec_int4)b >> 31);
  return spu_emu::detail::any_set(spu_cmpabsgt(a, b) | no_bound);
}

// Every element within the bounds.
SPU_EMU_INLINE int vec_all_in(vec_float4 a, vec_float4 b) {
  return 1 - vec_any_out(a, b);
}

#endif
