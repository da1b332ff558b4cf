// Which vectors the vmx2spu.h templates take, and the vector that belongs to a pointer.
//
// Boolean vectors are the unsigned vectors of their width, as on an SPU; where the PPU's functions mix a
// boolean with a signed or float vector, the result has the other operand's type.
#ifndef SPU_EMU_INTRINSICS_VMX_TYPES_H
#define SPU_EMU_INTRINSICS_VMX_TYPES_H

#include "spu_emu/intrinsics/scalar.h"

namespace spu_emu::detail {

template <typename V>
constexpr bool is_signed_vector = is_integer_of<V, 1, 2, 4>&& std::is_signed_v<Element<V>>;

template <typename V>
using IfSigned = std::enable_if_t<is_signed_vector<V>, V>;

// Result type R for a V that may meet a boolean vector.
template <typename V, typename R>
using IfMixes = std::enable_if_t<is_signed_vector<V>, R>;

// The same for the bitwise functions, which mix floats with booleans, too.
template <typename V, typename R>
using IfMixesBits = std::enable_if_t<is_signed_vector<V> || std::is_same_v<Element<V>, float>, R>;

// What is loaded through a pointer to T: T itself for a vector, else a vector of T.
template <typename T, typename = void>
struct Pointee {
  using type = VectorOfT<T>;
};
template <typename T>
struct Pointee<T, std::void_t<Element<T>>> {
  using type = T;
};
template <typename T>
using PointeeT = typename Pointee<std::remove_cv_t<T>>::type;

}  // namespace spu_emu::detail

#endif
