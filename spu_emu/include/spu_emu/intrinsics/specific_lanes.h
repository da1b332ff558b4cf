// How the si_ functions see a qword: as lanes in any order, where all lanes are treated alike, or in true
// order.
#ifndef SPU_EMU_INTRINSICS_SPECIFIC_LANES_H
#define SPU_EMU_INTRINSICS_SPECIFIC_LANES_H

#include "spu_emu/intrinsics/qword.h"
#include "spu_emu/intrinsics/scalar.h"

namespace spu_emu::detail {

// The register's lanes, neighbours within a word swapped against the SPU; free of cost. Only for operations
// that do the same in every lane.
template <typename V>
SPU_EMU_INLINE V any_order(qword q) {
  return (V)(vec_uint4)q;
}

template <typename V>
SPU_EMU_INLINE qword of_any_order(V v) {
  return (qword)(vec_uint4)v;
}

// An immediate operand in all lanes: its low bits, which for a sign-extended immediate keep its value.
template <typename V>
SPU_EMU_INLINE V immediate(int value) {
  return splat<V>(static_cast<Element<V>>(value));
}

// Preferred slot of a shift count register.
SPU_EMU_INLINE int preferred(qword q) {
  return (int)((vec_int4)q)[0];
}

}  // namespace spu_emu::detail

#endif
