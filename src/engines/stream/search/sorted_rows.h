/// @file
/// Boxes in the order of an axis.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/search/sweep_row.h"

namespace cellsweep::stream {

class SortedRows {
 public:
  /// Puts rows in order, which have so many numbers on the axis, a power of two.
  void sort(std::span<const SweepRow> rows, std::uint32_t numbers);

  /// With the boxes by slot; valid until the next sort().
  SweptBoxes view(std::span<const Aabb> boxes) const;
  /// How many comparisons in bytes a sweep makes: of each box with those behind it that begin before it ends.
  std::uint64_t comparisons() const { return comparisons_; }

  std::size_t bytes() const { return next_.bytes() + slots_.bytes() + ends_.bytes() + bytes_.bytes(); }

 private:
  Array<std::uint32_t> next_;  // for each number
  Array<Slot> slots_;
  Array<std::uint32_t> ends_;
  Array<std::uint32_t> bytes_;
  std::uint64_t comparisons_ = 0;
};

}  // namespace cellsweep::stream
