/// @file
/// A grid of 64 x 64 x 64 cells, and a bit for each of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/box_lanes.h"

namespace cellsweep::one_shot {

/// Cells on each axis: those along x are the bits of a word.
constexpr std::int32_t kCoarseDims = 64;

/// A bit for each cell, in rows along x.
using CoarseCells = std::array<std::uint64_t, std::size_t{kCoarseDims} * kCoarseDims>;

/// A space cut into cells. Which cell a coordinate falls into never decreases with it, so
/// that boxes which overlap share one.
class CoarseGrid {
 public:
  explicit CoarseGrid(const Aabb& space) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double length = double{space.max[axis]} - double{space.min[axis]};
      origin_[axis] = space.min[axis];
      cell_[axis] = static_cast<float>(length / kCoarseDims);
      scale_[axis] = length > 1e-30 ? static_cast<float>(kCoarseDims / length) : 0;
    }
  }

  /// With a cell more on each side.
  BoxLanes around(BoxLanes box) const {
    box.min -= cell_;
    box.max += cell_;
    return box;
  }

  /// Calls `visit(row, bits)` for the rows of cells that a box reaches into, until that returns true. Whether
  /// it did.
  template <class Visit>
  bool any_row(const BoxLanes& box, const Visit& visit) const {
    const Int4 low = cells_of(box.min);
    const Int4 high = cells_of(box.max);
    const std::uint64_t bits = ~std::uint64_t{0} >> (kCoarseDims - 1 - (high[0] - low[0])) << low[0];
    for (std::int32_t z = low[2]; z <= high[2]; ++z) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        if (visit(static_cast<std::size_t>(z) * kCoarseDims + static_cast<std::size_t>(y), bits)) return true;
      }
    }
    return false;
  }

 private:
  // An infinite coordinate, times a scale of 0, falls into cell 0.
  Int4 cells_of(Float4 coordinates) const {
    constexpr auto kTop = static_cast<float>(kCoarseDims - 1);
    return cellsweep::cells_of(coordinates, origin_, scale_, Float4{kTop, kTop, kTop, kTop});
  }

  Float4 origin_{};
  Float4 scale_{};
  Float4 cell_{};  // its edges
};

}  // namespace cellsweep::one_shot
