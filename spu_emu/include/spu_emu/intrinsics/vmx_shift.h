// vmx2spu.h: shifts and rotates. Counts per element are taken modulo the element's bits, also where spu_
// functions take them modulo twice that.
#ifndef SPU_EMU_INTRINSICS_VMX_SHIFT_H
#define SPU_EMU_INTRINSICS_VMX_SHIFT_H

#include "spu_emu/intrinsics/quadword.h"
#include "spu_emu/intrinsics/qword.h"
#include "spu_emu/intrinsics/shift.h"
#include "spu_emu/intrinsics/vmx_types.h"

namespace spu_emu::detail {

template <typename V>
SPU_EMU_INLINE Unsigned<V> count_in_lane(Unsigned<V> count) {
  return count & splat<Unsigned<V>>(static_cast<Element<Unsigned<V>>>(lane_bits<V> - 1));
}

// Word `element` of any vector, as the SPU numbers its words.
template <typename V>
SPU_EMU_INLINE unsigned int word_of(V v, int element) {
  return ((vec_uint4)(qword)v)[element];
}

}  // namespace spu_emu::detail

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_sl(V a, spu_emu::detail::Unsigned<V> count) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)(U)((U)a << spu_emu::detail::count_in_lane<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_sr(V a, spu_emu::detail::Unsigned<V> count) {
  using U = spu_emu::detail::Unsigned<V>;
  return (V)(U)((U)a >> spu_emu::detail::count_in_lane<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_sra(V a, spu_emu::detail::Unsigned<V> count) {
  using S = spu_emu::detail::Signed<V>;
  return (V)(S)((S)a >> (S)spu_emu::detail::count_in_lane<V>(count));
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::IfInteger<V, V, 1, 2, 4> vec_rl(V a, spu_emu::detail::Unsigned<V> count) {
  using U = spu_emu::detail::Unsigned<V>;
  const U left = spu_emu::detail::count_in_lane<V>(count);
  const U right = spu_emu::detail::count_in_lane<V>((U)(U{} - left));
  return (V)(U)((U)((U)a << left) | (U)((U)a >> right));
}

// Whole vectors: by 0-7 bits (vec_sll, vec_srl) or 0-15 bytes (vec_slo, vec_sro), the count being in every
// byte of b or, for bytes, in bits 3-6 of its last one.
template <typename V, typename C>
SPU_EMU_INLINE V vec_sll(V a, C b) {
  return spu_slqw(a, spu_emu::detail::word_of(b, 0));
}

template <typename V, typename C>
SPU_EMU_INLINE V vec_slo(V a, C b) {
  return spu_slqwbytebc(a, spu_emu::detail::word_of(b, 3) & 0x7f);
}

template <typename V, typename C>
SPU_EMU_INLINE V vec_srl(V a, C b) {
  return spu_srqw(a, spu_emu::detail::word_of(b, 3));
}

template <typename V, typename C>
SPU_EMU_INLINE V vec_sro(V a, C b) {
  return spu_srqwbyte(a, (spu_emu::detail::word_of(b, 3) >> 3) & 15);
}

// Bytes count to count + 15 of the 32 bytes of a and b.
template <typename V>
SPU_EMU_INLINE V vec_sld(V a, V b, unsigned int count) {
  const vec_uchar16 numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  return spu_shuffle(a, b,
                     numbers + spu_emu::detail::splat<vec_uchar16>(static_cast<unsigned char>(count & 15)));
}

// Only the low five bits of a pattern byte count, so there are no special selectors.
template <typename V>
SPU_EMU_INLINE V vec_perm(V a, V b, vec_uchar16 pattern) {
  return spu_shuffle(a, b, pattern & spu_emu::detail::splat<vec_uchar16>(31));
}

#endif
