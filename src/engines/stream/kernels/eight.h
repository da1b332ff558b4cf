/// @file
/// Cells of eight boxes, one after the other: for kernels without integer vectors of eight.
#pragma once

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {
namespace {

inline std::uint32_t cell_on_axis(float coordinate, const GridNumbers& grid, unsigned axis) {
  float cell = (coordinate - grid.origin[axis]) * grid.scale[axis];
  cell = cell > 0 ? cell : 0;
  cell = cell < grid.top[axis] ? cell : grid.top[axis];
  return static_cast<std::uint32_t>(cell);
}

inline void eight_blocks_in_turn(const Aabb* boxes, std::size_t step, const GridNumbers& grid,
                                 EightBlocks& blocks) {
  const std::uint32_t steps[3] = {1, grid.row, grid.plane};
  for (unsigned i = 0; i < 8; ++i) {
    const auto* face = reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(boxes) + i * step);
    std::uint32_t first = 0, second = 0, more = 0, flags = kWholeFlags;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const std::uint32_t low = cell_on_axis(face[axis], grid, axis);
      const std::uint32_t high = cell_on_axis(face[axis + 3], grid, axis);
      first += low * steps[axis];
      second += high * steps[axis];
      more += high - low;
      flags ^= (high - low) << axis;
    }
    blocks.first[i] = first | kWholeFlags << kSlotBits;
    blocks.second[i] = second | flags << kSlotBits;
    blocks.more[i] = face[0] <= face[3] ? more : EightBlocks::kNobody;
  }
}

}  // namespace
}  // namespace cellsweep::stream
