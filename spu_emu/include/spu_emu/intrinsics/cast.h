// The cast between vector types as the SPU has it: the register's bytes stay, seen in the order of the SPU.
#ifndef SPU_EMU_INTRINSICS_CAST_H
#define SPU_EMU_INTRINSICS_CAST_H

#include "spu_emu/intrinsics/qword.h"

namespace spu_emu {

namespace detail {

template <typename V, typename = void>
constexpr bool is_vector = false;
template <typename V>
constexpr bool is_vector<V, std::void_t<typename VecTraits<V>::Element>> = true;

/// For the byte at `index` of a vector with lanes of To bytes, in the host's order: where it lies in one with
/// lanes of From bytes.
template <int To, int From>
constexpr int byte_of(int index) {
  if (is_big_endian) return index;
  const int place = index / To * To + (To - 1 - index % To);
  return place / From * From + (From - 1 - place % From);
}

/// By the compiler's own shuffle, which it computes at compile time for constants.
template <int To, int From>
SPU_EMU_INLINE vec_uchar16 reordered(vec_uchar16 v) {
#define SPU_EMU_BYTE(index) byte_of<To, From>(index)
  return __builtin_shufflevector(v, v, SPU_EMU_BYTE(0), SPU_EMU_BYTE(1), SPU_EMU_BYTE(2), SPU_EMU_BYTE(3),
                                 SPU_EMU_BYTE(4), SPU_EMU_BYTE(5), SPU_EMU_BYTE(6), SPU_EMU_BYTE(7),
                                 SPU_EMU_BYTE(8), SPU_EMU_BYTE(9), SPU_EMU_BYTE(10), SPU_EMU_BYTE(11),
                                 SPU_EMU_BYTE(12), SPU_EMU_BYTE(13), SPU_EMU_BYTE(14), SPU_EMU_BYTE(15));
#undef SPU_EMU_BYTE
}

}  // namespace detail

/// What a cast in a translated source calls.
template <typename To, typename From, std::enable_if_t<!std::is_reference_v<To>, int> = 0>
SPU_EMU_INLINE constexpr To cast(From value) {
  using ToVector = std::remove_cv_t<To>;
  if constexpr (detail::is_vector<ToVector> && detail::is_vector<From>) {
    constexpr int to = detail::lane_bytes<ToVector>;
    constexpr int from = detail::lane_bytes<From>;
    if constexpr (to == from)
      return (To)value;
    else
      return (To)detail::reordered<to, from>((vec_uchar16)value);
  } else {
    return (To)value;
  }
}

/// To a type that turns out to be a reference: of the same kind of vector, or to what is none.
template <typename To, typename From, std::enable_if_t<std::is_reference_v<To>, int> = 0>
SPU_EMU_INLINE constexpr To cast(From&& value) {
  using ToVector = std::remove_cv_t<std::remove_reference_t<To>>;
  using FromVector = std::remove_cv_t<std::remove_reference_t<From>>;
  static_assert(!detail::is_vector<ToVector> || std::is_same_v<ToVector, FromVector>,
                "a reference to a vector of another type: its bytes would be in another order");
  return (To)value;
}

}  // namespace spu_emu

#endif
