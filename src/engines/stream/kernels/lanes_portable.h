/// @file
/// Boxes side by side in plain C++.
#pragma once

#include "engines/stream/kernels/eight.h"
#include "engines/stream/kernels/faces.h"

namespace cellsweep::stream {
namespace {

/// Four boxes at a time in plain C++.
struct PortableLanes {
  static constexpr unsigned kCount = 4;
  static constexpr auto kEightBlocks = eight_blocks_in_turn;
  struct Vector {
    float lane[kCount];
  };
  using Mask = std::uint32_t;

  static void gather(const TaggedBox* boxes, std::uint32_t /*there*/, Vector (&faces)[6]) {
    for (unsigned i = 0; i < kCount; ++i) {
      const float* const from = faces_of(boxes[i].box);
      for (unsigned axis = 0; axis < 3; ++axis) {
        faces[axis].lane[i] = from[axis];
        faces[axis + 3].lane[i] = from[axis + 3];
      }
    }
  }
  static Vector broadcast(const float* from) { return {{*from, *from, *from, *from}}; }
  static Mask less_equal(const Vector& a, const Vector& b) {
    Mask mask = 0;
    for (unsigned i = 0; i < kCount; ++i) mask |= (a.lane[i] <= b.lane[i] ? 1U : 0U) << i;
    return mask;
  }
  static Mask both(Mask a, Mask b) { return a & b; }
  static std::uint32_t bits(Mask mask) { return mask; }
};

}  // namespace
}  // namespace cellsweep::stream
