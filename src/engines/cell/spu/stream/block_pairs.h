/// @file
/// Blocks of boxes in the local store, and one box against a block of them, four at a time.
#pragma once

#include <spu_intrinsics.h>

#include "engines/cell/spu/stream/pair_stream.h"

namespace cellsweep::cell {

/// Boxes as they come, two vectors each.
struct Block {
  vec_float4* boxes;
  std::uint32_t count;

  float value(unsigned int face, std::uint32_t box) const {
    return reinterpret_cast<const float*>(boxes)[kStreamWords * box + face];
  }
  std::uint32_t tag(std::uint32_t box) const {
    return reinterpret_cast<const std::uint32_t*>(boxes)[kStreamWords * box + kStreamTag];
  }
};

/// A block by coordinate: seven arrays of kStreamBlock words, min x, y, z, max x, y, z, tag.
struct Columns {
  vec_float4* arrays;
  std::uint32_t count;

  void fill(const Block& block);

  const vec_float4* array(unsigned int index) const { return arrays + index * (kStreamBlock / 4); }
  std::uint32_t tag(std::uint32_t box) const {
    return reinterpret_cast<const std::uint32_t*>(array(kStreamTag))[box];
  }
};

/// Adds the pairs of box `row` of `block` with the boxes of `others` from `from` on that the cell owns.
void add_row(const Block& block, std::uint32_t row, const Columns& others, std::uint32_t from,
             PairStream& pairs);

}  // namespace cellsweep::cell
