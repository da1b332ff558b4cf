/// @file
/// A box as two vectors of four, for what is asked of every box: three axes at a time, without branches.
#pragma once

#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "cellsweep/aabb.h"

namespace cellsweep {

using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;

/// Four floats of a box, from `skip` on.
inline Float4 load4(const Aabb& box, std::size_t skip) {
  Float4 vector;
  std::memcpy(&vector, reinterpret_cast<const char*>(&box) + skip * sizeof(float), sizeof vector);
  return vector;
}

/// Lanes 0 to 2 are the axes; what lane 3 holds must not matter.
struct BoxLanes {
  Float4 min;
  Float4 max;

  explicit BoxLanes(const Aabb& box) : min(load4(box, 0)), max(load4(box, 2)) {
    max = __builtin_shufflevector(max, max, 1, 2, 3, 0);
  }
};

/// True when a comparison holds on all three axes.
inline bool on_all_axes(Int4 mask) {
#ifdef __SSE2__
  return (_mm_movemask_ps(reinterpret_cast<__m128>(mask)) & 7) == 7;
#else
  return (mask[0] & mask[1] & mask[2]) != 0;
#endif
}

inline bool overlap(const BoxLanes& one, const BoxLanes& other) {
  return on_all_axes((one.min <= other.max) & (other.min <= one.max));
}

inline bool encloses(const BoxLanes& fat, const BoxLanes& box) {
  return on_all_axes((fat.min <= box.min) & (box.max <= fat.max));
}

inline bool same_bits(const BoxLanes& one, const BoxLanes& other) {
  return on_all_axes((reinterpret_cast<Int4>(one.min) == reinterpret_cast<Int4>(other.min)) &
                     (reinterpret_cast<Int4>(one.max) == reinterpret_cast<Int4>(other.max)));
}

/// Lanes that canonical() leaves as they are, and that are finite.
inline Int4 clean_lanes(Float4 values) {
  const Int4 bits = reinterpret_cast<Int4>(values);
  const Int4 magnitude = bits & 0x7fffffff;
  return (bits == 0) | ((magnitude > 0x007fffff) & (magnitude < 0x7f800000));
}

/// Lanes whose values are clean_lanes(), the minimum not above the maximum.
inline Int4 clean_lanes(const BoxLanes& box) {
  return clean_lanes(box.min) & clean_lanes(box.max) & (box.min <= box.max);
}

}  // namespace cellsweep
