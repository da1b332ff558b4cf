/// @file
/// The inner loops of engine `stream`: a cell's boxes against each other, as many at a time as a vector
/// holds.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cellsweep/aabb.h"
#include "cellsweep/engine/cell_boxes.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep::stream {

/// The largest vector of any kernel, in boxes.
inline constexpr std::uint32_t kMaxLanes = 16;

/// The numbers of a Grid: a coordinate's cell on an axis is (coordinate - origin) * scale, cut off below 0
/// and above `top`; NaN is 0. A cell's number is x + row * y + plane * z.
struct GridNumbers {
  float origin[3];
  float scale[3];
  float top[3];
  std::uint32_t row;
  std::uint32_t plane;
};

/// Into which cells eight boxes reach.
struct alignas(32) EightBlocks {
  static constexpr std::uint32_t kNobody = ~0U;

  std::uint32_t first[8];   ///< the first cell, under the flags of a box that starts in it on all axes
  std::uint32_t second[8];  ///< of two cells the second, under its flags; of one the same
  std::uint32_t more[8];    ///< cells more on all axes together: 0, 1 and then not two; kNobody for NaN
};

/// Boxes on two axes in bytes, in the order of a third axis. Behind the last one there is room for as many as
/// a vector holds, with anything in it.
struct SweptBoxes {
  const std::uint8_t* low_y;
  const std::uint8_t* high_y;
  const std::uint8_t* low_z;
  const std::uint8_t* high_z;
  const std::uint32_t* end;  ///< for each the first one behind it that begins beyond it
  std::uint32_t count;
};

/// A box, and which of those from `first` on it overlaps as far as bytes tell, a bit each.
struct SweptHits {
  std::uint64_t lanes;
  std::uint32_t place;
  std::uint32_t first;
};

/// The kernels of one instruction set. Keys are those of slots.
///
/// Of the cells that two overlapping boxes share, one owns the pair: that which holds the lower corner of
/// what they share. It does when on each axis one of the two minima lies in the cell, which the tags tell.
struct Kernels {
  VectorIsa isa;
  const char* name;
  unsigned lanes;

  /// Finds the cells of eight boxes that lie `step` bytes apart.
  void (*eight_blocks)(const Aabb* boxes, std::size_t step, const GridNumbers& grid, EightBlocks& blocks);

  /// Appends every overlapping pair that the cell owns of one of its first `rows` boxes with one behind it.
  void (*all_pairs)(const CellBoxes& cell, std::uint32_t rows, KeyBuffer& found);

  /// Appends the slots of the boxes that overlap this one, where the cell owns the pair.
  void (*partners)(const CellBoxes& cell, const TaggedBox& box, KeyBuffer& slots);

  /// Compares boxes from `place` on with those behind them, as far as there is room for `most` hits, and says
  /// how many there are; `place` becomes the first box that was not compared. `most` is at least one for each
  /// vector of boxes. Null where there are no vectors of bytes.
  std::uint32_t (*sweep)(const SweptBoxes& boxes, std::uint32_t& place, SweptHits* hits, std::uint32_t most);
};

/// The kernels of an instruction set, or of the best one; null when this processor or build does not have it.
const Kernels* find_kernels(VectorIsa isa);

}  // namespace cellsweep::stream
