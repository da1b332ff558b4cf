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

/// Eight boxes in small numbers: on one axis two of 16 bits each, the lower end below the upper one, and on
/// the other two axes bytes: lower and upper end on the next axis, lower and upper end on the one after it.
struct alignas(32) EightRows {
  std::uint32_t on_axis[8];
  std::uint32_t on_others[8];
  std::uint32_t there;  ///< a bit for each that is somebody: not NaN
};

/// Boxes on two axes in bytes, in the order of a third axis.
struct SweptBoxes {
  /// Behind the last one there is room for so many more, with anything in it.
  static constexpr std::uint32_t kRoom = 64;

  const std::uint32_t* bytes;  ///< of each from the lowest on: low y, 255 - high y, low z, 255 - high z
  const std::uint32_t* end;    ///< for each the first one behind it that begins beyond it
  const std::uint32_t* slots;  ///< of each,
  const Aabb* boxes;           ///< and the boxes by slot
  std::uint32_t count;
};

struct SweepResult {
  std::uint64_t tests;  ///< boxes tested
  bool found_all;       ///< it did not give up
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

  /// Finds the small numbers of eight boxes: cells of the grid, as GridNumbers says, of which there are no
  /// more than 65,536 on this axis and 256 on the others. Null where there are no vectors of bytes.
  void (*eight_rows)(const Aabb* boxes, const GridNumbers& grid, unsigned axis, EightRows& rows);

  /// Compares each box with those behind it, tests the boxes of those that overlap as far as bytes tell, and
  /// appends the pairs. Gives up, with some pairs missing, after more tests than four for each pair and
  /// these. Null where there are no vectors of bytes.
  SweepResult (*sweep)(const SweptBoxes& boxes, std::uint64_t tests, KeyBuffer& found);
};

/// The kernels of an instruction set, or of the best one; null when this processor or build does not have it.
const Kernels* find_kernels(VectorIsa isa);

}  // namespace cellsweep::stream
