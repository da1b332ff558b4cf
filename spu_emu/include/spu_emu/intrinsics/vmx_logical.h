// vmx2spu.h: bitwise functions, with boolean vectors among the operands.
#ifndef SPU_EMU_INTRINSICS_VMX_LOGICAL_H
#define SPU_EMU_INTRINSICS_VMX_LOGICAL_H

#include "spu_emu/intrinsics/logical.h"
#include "spu_emu/intrinsics/vmx_types.h"

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V vec_and(V a, V b) {
  return spu_and(a, b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V vec_andc(V a, V b) {
  return spu_andc(a, b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V vec_or(V a, V b) {
  return spu_or(a, b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V vec_xor(V a, V b) {
  return spu_xor(a, b);
}

template <typename V, typename = spu_emu::detail::Element<V>>
SPU_EMU_INLINE V vec_nor(V a, V b) {
  return spu_nor(a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_and(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_and((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_and(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_and(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_andc(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_andc((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_andc(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_andc(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_or(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_or((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_or(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_or(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_xor(spu_emu::detail::Unsigned<V> a, V b) {
  return vec_xor((V)a, b);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfMixesBits<V, V> vec_xor(V a, spu_emu::detail::Unsigned<V> b) {
  return vec_xor(a, (V)b);
}

template <typename V>
SPU_EMU_INLINE V vec_sel(V a, V b, spu_emu::detail::Unsigned<V> mask) {
  return spu_sel(a, b, mask);
}

#endif
