// vmx2spu.h: splats, single elements, and carries, all forwards to their spu_ counterparts.
#ifndef SPU_EMU_INTRINSICS_VMX_SCALAR_H
#define SPU_EMU_INTRINSICS_VMX_SCALAR_H

#include "spu_emu/intrinsics/arithmetic.h"
#include "spu_emu/intrinsics/scalar.h"

template <typename V>
SPU_EMU_INLINE auto vec_extract(V v, int element) {
  return spu_extract(v, element);
}

template <typename V>
SPU_EMU_INLINE V vec_insert(spu_emu::detail::Element<V> scalar, V v, int element) {
  return spu_insert(scalar, v, element);
}

template <typename S>
SPU_EMU_INLINE auto vec_promote(S scalar, int element) {
  return spu_promote(scalar, element);
}

template <typename S>
SPU_EMU_INLINE auto vec_splats(S scalar) {
  return spu_splats(scalar);
}

// All elements equal to the one named.
template <typename V>
SPU_EMU_INLINE V vec_splat(V v, int element) {
  return spu_emu::detail::splat<V>(spu_extract(v, element));
}

template <typename S>
SPU_EMU_INLINE vec_char16 vec_splat_s8(S scalar) {
  return spu_emu::detail::splat<vec_char16>(static_cast<spu_emu::detail::Element<vec_char16>>(scalar));
}

template <typename S>
SPU_EMU_INLINE vec_short8 vec_splat_s16(S scalar) {
  return spu_emu::detail::splat<vec_short8>(static_cast<spu_emu::detail::Element<vec_short8>>(scalar));
}

template <typename S>
SPU_EMU_INLINE vec_int4 vec_splat_s32(S scalar) {
  return spu_emu::detail::splat<vec_int4>(static_cast<spu_emu::detail::Element<vec_int4>>(scalar));
}

template <typename S>
SPU_EMU_INLINE vec_uchar16 vec_splat_u8(S scalar) {
  return spu_emu::detail::splat<vec_uchar16>(static_cast<spu_emu::detail::Element<vec_uchar16>>(scalar));
}

template <typename S>
SPU_EMU_INLINE vec_ushort8 vec_splat_u16(S scalar) {
  return spu_emu::detail::splat<vec_ushort8>(static_cast<spu_emu::detail::Element<vec_ushort8>>(scalar));
}

template <typename S>
SPU_EMU_INLINE vec_uint4 vec_splat_u32(S scalar) {
  return spu_emu::detail::splat<vec_uint4>(static_cast<spu_emu::detail::Element<vec_uint4>>(scalar));
}

template <typename V>
SPU_EMU_INLINE V vec_addc(V a, V b) {
  return spu_genc(a, b);
}

template <typename V>
SPU_EMU_INLINE V vec_subc(V a, V b) {
  return spu_genb(a, b);
}

#endif
