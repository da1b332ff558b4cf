#include "one_shot/apart.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/memory/array.h"
#include "base/tuning.h"
#include "geometry/bounds.h"
#include "geometry/box_lanes.h"

namespace cellsweep::one_shot {
namespace {

/// Cells on each axis: those along x are the bits of a word.
constexpr std::int32_t kDims = 64;

/// Cells, a bit each, in rows along x.
using Cells = std::array<std::uint64_t, std::size_t{kDims} * kDims>;

/// What both sets reach into, cut into cells. Which cell a coordinate falls into never decreases with it, so
/// that boxes which overlap share one.
class CoarseGrid {
 public:
  explicit CoarseGrid(const Aabb& space) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double length = double{space.max[axis]} - double{space.min[axis]};
      origin_[axis] = space.min[axis];
      scale_[axis] = length > 1e-30 ? static_cast<float>(kDims / length) : 0;
    }
  }

  /// Calls `visit(row, bits)` for the rows of cells that a box reaches into, until that returns true. Whether
  /// it did.
  template <class Visit>
  bool any_row(const BoxLanes& box, const Visit& visit) const {
    const Int4 low = cells_of(box.min);
    const Int4 high = cells_of(box.max);
    const std::uint64_t bits = ~std::uint64_t{0} >> (kDims - 1 - (high[0] - low[0])) << low[0];
    for (std::int32_t z = low[2]; z <= high[2]; ++z) {
      for (std::int32_t y = low[1]; y <= high[1]; ++y) {
        if (visit(static_cast<std::size_t>(z) * kDims + static_cast<std::size_t>(y), bits)) return true;
      }
    }
    return false;
  }

 private:
  // NaN, 0 times what is infinite, becomes 0.
  Int4 cells_of(Float4 coordinates) const {
    const Float4 zero{};
    const Float4 top = zero + static_cast<float>(kDims - 1);
    Float4 cells = (coordinates - origin_) * scale_;
    cells = cells > zero ? cells : zero;
    cells = cells < top ? cells : top;
    return __builtin_convertvector(cells, Int4);
  }

  Float4 origin_{};
  Float4 scale_{};
};

class Apart {
 public:
  explicit Apart(SearchedBoxes& boxes) : boxes_(boxes) {}

  void leave_out() {
    if (!find_space()) return keep([](std::size_t, const BoxLanes&) { return false; });
    const BoxLanes space(space_);
    const CoarseGrid grid(space_);
    // Few boxes are swept in less time than it takes to mark where they are.
    const bool are_few = boxes_.boxes.size() <= tuning::kMostSwept;
    if (are_few || !mark(grid))
      return keep([&](std::size_t, const BoxLanes& box) { return overlap(box, space); });
    keep([&](std::size_t set, const BoxLanes& box) {
      const Cells& others = cells_.data()[1 - set];
      const auto meets = [&](std::size_t row, std::uint64_t bits) { return (others[row] & bits) != 0; };
      return overlap(box, space) && grid.any_row(box, meets);
    });
  }

 private:
  std::size_t set_of(std::size_t slot) const { return slot < boxes_.second ? 0 : 1; }

  // What a pair shares lies in the bounds of both sets. False when these have nothing in common.
  bool find_space() {
    std::array<Bounds, 2> bounds;
    for (std::size_t slot = 0; slot < boxes_.boxes.size(); ++slot)
      bounds[set_of(slot)].include(boxes_.boxes[slot]);
    const Aabb one = bounds[0].box();
    const Aabb other = bounds[1].box();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      space_.min[axis] = std::max(one.min[axis], other.min[axis]);
      space_.max[axis] = std::min(one.max[axis], other.max[axis]);
    }
    return overlap(one, other);
  }

  // The cells that each set reaches into. False when boxes are too large.
  bool mark(const CoarseGrid& grid) {
    const BoxLanes space(space_);
    cells_.renew(2);
    for (Cells& cells : cells_.view()) cells.fill(0);
    const std::uint64_t most = tuning::kRowsOfApart * boxes_.boxes.size();
    std::uint64_t rows = 0;
    for (std::size_t slot = 0; slot < boxes_.boxes.size() && rows <= most; ++slot) {
      const BoxLanes box(boxes_.boxes[slot]);
      if (!overlap(box, space)) continue;
      Cells& cells = cells_.data()[set_of(slot)];
      grid.any_row(box, [&](std::size_t row, std::uint64_t bits) {
        cells[row] |= bits;
        ++rows;
        return false;
      });
    }
    return rows <= most;
  }

  /// Keeps those of which `is_near(set, box)` says so.
  template <class IsNear>
  void keep(const IsNear& is_near) {
    const std::span<const Aabb> all = boxes_.boxes;
    Array<std::uint32_t> places;
    places.renew(all.size());
    std::uint32_t kept = 0;
    std::uint32_t second = 0;
    for (std::uint32_t place = 0; place < all.size(); ++place) {
      if (place == boxes_.second) second = kept;
      places.data()[kept] = place;
      kept += is_near(set_of(place), BoxLanes(all[place])) ? 1 : 0;
    }
    // To leave out a few pays less than it takes.
    if (kept > all.size() - all.size() / 8) return;
    for (std::uint32_t slot = 0; slot < kept; ++slot) boxes_.own.data()[slot] = all[places.data()[slot]];
    places.shrink(kept);
    boxes_.places = std::move(places);
    boxes_.boxes = all.first(kept);
    boxes_.second = second;
  }

  SearchedBoxes& boxes_;
  Aabb space_;
  Array<Cells> cells_;  // by set
};

}  // namespace

void leave_out_apart(SearchedBoxes& boxes) {
  if (boxes.second == 0 || boxes.second == boxes.boxes.size()) return;
  Apart(boxes).leave_out();
}

}  // namespace cellsweep::one_shot
