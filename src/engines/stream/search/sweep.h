/// @file
/// All pairs of a world without cells: boxes in the order of one axis, the other two in bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/search/number_map.h"
#include "engines/stream/search/sorted_rows.h"

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
  std::size_t bytes() const { return rows_.bytes() + sorted_.bytes(); }

 private:
  void sort(const Kernels& kernels, std::span<const Aabb> boxes);
  void make_rows(const Kernels& kernels, std::span<const Aabb> boxes);
  [[gnu::cold]] bool promises(const Kernels& kernels, std::span<const Aabb> boxes) const;
  bool pays(const Kernels& kernels) const;
  bool find_pairs(const Kernels& kernels, std::span<const Aabb> boxes, KeyBuffer& found);

  NumberMap map_;
  Array<SweepRow> rows_;
  SortedRows sorted_;
  std::uint64_t compared_ = 0;  // comparisons in bytes that a sweep of the sorted rows makes
  std::uint64_t tests_ = 0;
};

}  // namespace cellsweep::stream
