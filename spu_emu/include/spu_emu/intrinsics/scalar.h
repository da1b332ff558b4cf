// Moving scalars in and out of vectors: spu_splats, spu_promote, spu_extract, spu_insert.
//
// Element numbers wrap as on the SPU, where the number becomes a rotate count. `unsigned long` and `long`
// have 64 bits here, so that uint64_t finds the two-element vectors; on an SPU they had 32.
#ifndef SPU_EMU_INTRINSICS_SCALAR_H
#define SPU_EMU_INTRINSICS_SCALAR_H

#include "spu_emu/intrinsics/traits.h"

namespace spu_emu::detail {

template <typename S>
struct VectorOf;
template <>
struct VectorOf<unsigned char> {
  using type = vec_uchar16;
};
template <>
struct VectorOf<char> {
  using type = vec_uchar16;
};
template <>
struct VectorOf<signed char> {
  using type = vec_char16;
};
template <>
struct VectorOf<unsigned short> {
  using type = vec_ushort8;
};
template <>
struct VectorOf<short> {
  using type = vec_short8;
};
template <>
struct VectorOf<unsigned int> {
  using type = vec_uint4;
};
template <>
struct VectorOf<int> {
  using type = vec_int4;
};
template <>
struct VectorOf<unsigned long> {
  using type = vec_ullong2;
};
template <>
struct VectorOf<long> {
  using type = vec_llong2;
};
template <>
struct VectorOf<unsigned long long> {
  using type = vec_ullong2;
};
template <>
struct VectorOf<long long> {
  using type = vec_llong2;
};
template <>
struct VectorOf<float> {
  using type = vec_float4;
};
template <>
struct VectorOf<double> {
  using type = vec_double2;
};

template <typename S>
using VectorOfT = typename VectorOf<S>::type;

template <typename V>
SPU_EMU_INLINE int wrap_index(int element) {
  return element & (VecTraits<V>::count - 1);
}

}  // namespace spu_emu::detail

template <typename S>
SPU_EMU_INLINE spu_emu::detail::VectorOfT<S> spu_splats(S scalar) {
  using V = spu_emu::detail::VectorOfT<S>;
  return spu_emu::detail::splat<V>(static_cast<spu_emu::detail::Element<V>>(scalar));
}

// The other elements are undefined on an SPU; here they hold the scalar, too.
template <typename S>
SPU_EMU_INLINE spu_emu::detail::VectorOfT<S> spu_promote(S scalar, int) {
  return spu_splats(scalar);
}

template <typename V>
SPU_EMU_INLINE spu_emu::detail::Element<V> spu_extract(V v, int element) {
  return v[spu_emu::detail::wrap_index<V>(element)];
}

template <typename V>
SPU_EMU_INLINE V spu_insert(spu_emu::detail::Element<V> scalar, V v, int element) {
  v[spu_emu::detail::wrap_index<V>(element)] = scalar;
  return v;
}

#endif
