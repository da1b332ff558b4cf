/// @file
/// The kernel between two sets for any vector. What holds for engines/stream/kernels/body.h holds here.
#pragma once

#include "engines/stream/kernels/body.h"
#include "one_shot/kernels/cross.h"

namespace cellsweep::one_shot {
namespace {

template <class Lanes>
void cross_pairs(const stream::CellBoxes& cell, std::uint32_t rows, stream::KeyBuffer& found) {
  // Copies: what is written to `hits` must not look like a change of these.
  const stream::TaggedBox* const boxes = cell.boxes;
  const std::uint32_t end_of_cell = cell.count;
  stream::Hits hits[stream::kStrip];
  // Room behind the last box is in whole vectors from the first one on: so are blocks.
  for (std::uint32_t first = rows - rows % Lanes::kCount; first < end_of_cell; first += Lanes::kCount) {
    const stream::Block<Lanes> block(boxes + first, end_of_cell - first);
    const std::uint32_t before = first < rows ? stream::lanes_below<Lanes>(rows - first) : 0;
    const std::uint32_t there = stream::lanes_below<Lanes>(end_of_cell - first) & ~before;
    for (std::uint32_t strip = 0; strip < rows; strip += stream::kStrip) {
      const std::uint32_t strip_end = strip + stream::kStrip < rows ? strip + stream::kStrip : rows;
      std::size_t count = 0;
      for (std::uint32_t i = strip; i < strip_end; ++i) {
        hits[count] = {i, block.hits(boxes[i].box) & there};
        count += hits[count].lanes != 0 ? 1 : 0;
      }
      stream::make_room(found, count * Lanes::kCount);
      stream::add_pairs(hits, count, boxes, first, found);
    }
  }
}

}  // namespace
}  // namespace cellsweep::one_shot
