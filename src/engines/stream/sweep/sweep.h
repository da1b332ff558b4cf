/// @file
/// All pairs of a small world without cells: boxes in the order of one axis, the other two in bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "engines/stream/cells/grid.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/kernels/kernel.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

/// Coordinates become small numbers by maps that never decrease, so that no pair is missed; what overlaps in
/// small numbers is tested by its boxes.
class Sweep {
 public:
  /// Appends the keys of all pairs, in no order. False, and nothing is appended, when cells would take less:
  /// where small numbers tell too little. `boxes` are by slot, kNobody where there is no body. Throws
  /// TooManyPairs where `found` is limited.
  bool find(const Kernels& kernels, std::span<const Aabb> boxes, Keys& found);

  /// Comparisons of two boxes, in bytes or as they are, since it was made.
  std::uint64_t tests() const { return tests_; }
  std::size_t bytes() const;

 private:
  /// Maps coordinates of the three axes, in lanes 0 to 2, to whole numbers. NaN becomes 0.
  struct NumberMap {
    Float4 origin{};
    Float4 scale{};
    Float4 top{};

    Int4 operator()(Float4 coordinates) const;
  };

  bool knows_where(std::span<const Aabb> boxes) const;
  [[gnu::cold]] void learn(std::span<const Aabb> boxes);
  std::uint32_t sort(const Kernels& kernels, std::span<const Aabb> boxes);
  GridNumbers numbers() const;
  std::size_t room_of_rows() const { return rows_.size() / 3; }
  std::uint32_t make_rows(const Kernels& kernels, std::span<const Aabb> boxes);
  void sort_rows(std::uint32_t count);
  bool pays(const Kernels& kernels, std::uint32_t count) const;
  bool find_pairs(const Kernels& kernels, std::span<const Aabb> boxes, std::uint32_t count, KeyBuffer& found);

  NumberMap map_;
  unsigned axis_ = 0;            // of the order
  std::uint32_t places_ = 0;     // numbers on it
  std::uint32_t sweeps_ = 0;     // that the map was made or used for,
  std::size_t slots_known_ = 0;  // with so many slots
  // Of each box a row: its numbers, as EightRows says, and its slot. One list behind the other.
  Array<std::uint32_t> rows_;
  Array<std::uint32_t> sorted_;  // slots in the order of the axis
  Array<std::uint32_t> ends_;
  Array<std::uint8_t> bytes_;   // low y, high y, low z, high z
  std::uint64_t compared_ = 0;  // comparisons in bytes that a sweep of the sorted rows makes
  std::uint64_t tests_ = 0;
};

}  // namespace cellsweep::stream
