/// @file
/// Blocks of boxes in the local store, and one box against a block of them, four at a time.
#pragma once

#include <spu_intrinsics.h>

#include "engines/cell/spu/stream/pair_stream.h"

namespace cellsweep::cell {

/// Boxes as they come, two vectors each, and by coordinate: arrays of kStreamBlock words, min x, y, z,
/// max x, y, z, tag.
struct Block {
  vec_float4* boxes;
  vec_float4* arrays;
  std::uint32_t count;

  /// Fills the arrays.
  void transpose() const;

  const vec_float4* array(unsigned int index) const { return arrays + index * (kStreamBlock / 4); }
  float value(unsigned int index, std::uint32_t box) const {
    return reinterpret_cast<const float*>(array(index))[box];
  }
  std::uint32_t tag(std::uint32_t box) const { return reinterpret_cast<const std::uint32_t*>(array(6))[box]; }
};

/// Adds the pairs of box `row` of `block` with the boxes of `others` from `from` on that the cell owns.
void add_row(const Block& block, std::uint32_t row, const Block& others, std::uint32_t from,
             PairStream& pairs);

}  // namespace cellsweep::cell
