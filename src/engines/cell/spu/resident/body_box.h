/// @file
/// One box as two vectors, in the order in which a record carries it.
#pragma once

#include <spu_intrinsics.h>

#include <cstdint>

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/resident/lanes.h"

namespace cellsweep::cell {

/// A ResidentRecord: lower corner and the body's tag; upper corner and 0. A tag is the slot, and above it,
/// for the time of an order, the body's mark: the number of its record plus 1.
struct BodyBox {
  vec_float4 low;
  vec_float4 high;
};
static_assert(sizeof(BodyBox) == sizeof(ResidentRecord));

constexpr unsigned int kTagSlots = 0xffff;
constexpr unsigned int kMarkShift = 16;

constexpr unsigned int marked_tag(unsigned int slot, unsigned int record) {
  return slot | ((record + 1) << kMarkShift);
}

inline unsigned int tag_of(const BodyBox& box) {
  return spu_extract((vec_uint4)box.low, 3);
}
inline unsigned int slot_of(const BodyBox& box) {
  return tag_of(box) & kTagSlots;
}
inline void set_tag(BodyBox& box, unsigned int tag) {
  box.low = (vec_float4)spu_insert(tag, (vec_uint4)box.low, 3);
}

/// True when the two closed boxes share a point.
inline bool overlap(const BodyBox& a, const BodyBox& b) {
  const unsigned int corners = 14;  // without the tag
  return (mask_bits(spu_or(spu_cmpgt(a.low, b.high), spu_cmpgt(b.low, a.high))) & corners) == 0;
}

}  // namespace cellsweep::cell
