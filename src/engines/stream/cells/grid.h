/// @file
/// A grid of cells over part of the world, and how fine it should be.
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>

#include "base/tuning.h"
#include "cellsweep/engine/slots.h"
#include "engines/stream/kernels/kernel.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {

/// Boxes to be put into cells: those of a cell that is cut again, or all there are. Of these, a box's place
/// is its slot, every minimum is inside, and slots without a body have kNobody.
class Boxes {
 public:
  Boxes(const Aabb* boxes, std::size_t count)
      : first_(reinterpret_cast<const std::byte*>(boxes)), count_(count), step_(sizeof(Aabb)) {}
  explicit Boxes(const CellBoxes& cell)
      : first_(reinterpret_cast<const std::byte*>(cell.boxes)),
        count_(cell.count),
        step_(sizeof(TaggedBox)) {}

  std::size_t count() const { return count_; }
  /// So many of them from one on.
  Boxes part(std::size_t first, std::size_t count) const {
    Boxes boxes = *this;
    boxes.first_ += first * step_;
    boxes.count_ = count;
    return boxes;
  }
  /// Bytes from one to the next.
  std::size_t step() const { return step_; }
  const Aabb& operator[](std::size_t place) const {
    return *reinterpret_cast<const Aabb*>(first_ + place * step_);
  }
  std::uint32_t tag(std::size_t place) const {
    if (step_ == sizeof(Aabb)) return static_cast<std::uint32_t>(place) | kWholeFlags << kSlotBits;
    return reinterpret_cast<const TaggedBox*>(first_)[place].tag;
  }

 private:
  const std::byte* first_;
  std::size_t count_;
  std::size_t step_;
};
static_assert(offsetof(TaggedBox, box) == 0);

/// The block of cells that a box reaches into: the first one, and how many more on each axis.
struct CellBlock {
  std::uint32_t first = 0;
  std::uint32_t more_x = 0;
  std::uint32_t more_y = 0;
  std::uint32_t more_z = 0;

  bool is_one() const { return (more_x | more_y | more_z) == 0; }
  std::uint32_t cells() const { return (more_x + 1) * (more_y + 1) * (more_z + 1); }
  friend bool operator==(const CellBlock&, const CellBlock&) = default;
};

/// The cells that a box reaches into, by their places on each axis.
struct CellRange {
  std::uint32_t low[3];
  std::uint32_t high[3];
};

/// Cells that divide all of space: those at the border reach to infinity. Which cell a coordinate falls into
/// never decreases with the coordinate, whatever rounding does; exactness rests on that and on nothing else.
class Grid {
 public:
  /// One cell.
  Grid() = default;

  /// `dims[axis]` cells, 1 to kMaxDim, from `origin`, `scale[axis]` cells for each unit of length.
  Grid(const double (&origin)[3], const double (&scale)[3], const std::uint32_t (&dims)[3]);

  static constexpr std::uint32_t kMaxDim = 1023;

  std::uint32_t cells() const { return cells_; }

  GridNumbers numbers() const;

  CellBlock block_of(const Aabb& box) const { return block_of(load4(box, 0), load4(box, 2)); }
  CellBlock block_of(Float4 first_four, Float4 last_four) const {
    const Int4 low = cells_of(first_four, origin_min_, scale_min_, top_min_);
    const Int4 high = cells_of(last_four, origin_max_, scale_max_, top_max_);
    const auto x = static_cast<std::uint32_t>(low[0]);
    const auto y = static_cast<std::uint32_t>(low[1]);
    const auto z = static_cast<std::uint32_t>(low[2]);
    return {x + row_ * y + plane_ * z, static_cast<std::uint32_t>(high[1]) - x,
            static_cast<std::uint32_t>(high[2]) - y, static_cast<std::uint32_t>(high[3]) - z};
  }

  CellRange range_of(const Aabb& box) const {
    const Int4 low = cells_of(load4(box, 0), origin_min_, scale_min_, top_min_);
    const Int4 high = cells_of(load4(box, 2), origin_max_, scale_max_, top_max_);
    const auto place = [](std::int32_t lane) { return static_cast<std::uint32_t>(lane); };
    return {{place(low[0]), place(low[1]), place(low[2])}, {place(high[1]), place(high[2]), place(high[3])}};
  }

  /// Calls `visit(cell, flags)` for each cell of a block, flags as in tags: the axes on which the box starts
  /// in the cell.
  template <class Visit>
  void for_each_cell(const CellBlock& block, Visit&& visit) const {
    if (block.is_one()) return visit(block.first, kWholeFlags);
    for (std::uint32_t z = 0; z <= block.more_z; ++z) {
      for (std::uint32_t y = 0; y <= block.more_y; ++y) {
        const std::uint32_t row = block.first + z * plane_ + y * row_;
        const std::uint32_t flags = (y == 0 ? 2U : 0U) | (z == 0 ? 4U : 0U);
        for (std::uint32_t x = 0; x <= block.more_x; ++x) visit(row + x, flags | (x == 0 ? 1U : 0U));
      }
    }
  }

 private:
  // Minima lie in lanes 0 to 2 of a load, maxima in lanes 1 to 3 of another.
  Float4 origin_min_{};
  Float4 origin_max_{};
  Float4 scale_min_{};
  Float4 scale_max_{};
  Float4 top_min_{};
  Float4 top_max_{};
  std::uint32_t row_ = 1;    // cells from one to the next along y
  std::uint32_t plane_ = 1;  // and along z
  std::uint32_t cells_ = 1;
};

/// Which boxes are looked at before a grid is chosen. What few tell may be wrong by any factor, by chance or
/// because somebody placed the boxes so: where it turns out to be, all are looked at.
enum class Look {
  /// At few; and, when one of them is many times as long as is usual, at all for those that are, unless a
  /// look at some more shows many: one among the few would stand for thousands.
  at_few,
  at_all,
  /// At all, for a grid whose cells they cannot crowd even where each starts close to a border on every axis.
  at_all_carefully
};

/// A grid for boxes, and whether cutting is expected to pay.
struct GridChoice {
  Grid grid;
  bool pays = false;
  double copies = DBL_MAX;  ///< into how many cells boxes may reach, in the mean; else choose again

  std::size_t most_copies(std::size_t boxes) const;
};
/// Boxes reach into no more than so many cells, in the mean, if it is as expected; choose again where it is
/// not.
GridChoice choose_grid(const Boxes& boxes, Look look, double most_copies = tuning::kMostCopies);

/// Whether a choice made of few boxes is to be made again, of all, because it does not cut so many boxes or
/// leaves most of them in one cell.
inline bool is_doubtful(Look look, std::size_t boxes, std::size_t fullest_cell) {
  return look == Look::at_few && boxes >= tuning::kDoubted && fullest_cell > boxes / 4 * 3;
}

}  // namespace cellsweep::stream
