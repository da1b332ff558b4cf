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
#include "one_shot/coarse_grid.h"

namespace cellsweep::one_shot {
namespace {

/// So many boxes are looked at to tell how the sets lie.
constexpr std::size_t kVisited = 512;
/// To leave out fewer than one in so many takes more than it saves.
constexpr std::size_t kWorthIt = 8;

Aabb bounds_of(std::span<const Aabb> boxes) {
  Bounds bounds;
  for (const Aabb& box : boxes) bounds.include(box);
  return bounds.box();
}

class Apart {
 public:
  explicit Apart(SearchedBoxes& boxes)
      : boxes_(boxes), sets_{boxes.boxes.first(boxes.second), boxes.boxes.subspan(boxes.second)} {}

  void leave_out() {
    if (!find_space()) return keep_listed();
    const CoarseGrid grid(space_);
    // Few boxes are swept in less time than it takes to mark where they are.
    const bool are_few = boxes_.boxes.size() <= tuning::kMostSwept;
    const bool are_alone = !are_few && are_most_alone(grid);
    if (!are_few && !are_alone && !are_some_outside()) return;
    list_inside();
    if (are_alone) leave_out_alone(grid);
    keep_listed();
  }

 private:
  std::size_t set_of(std::size_t slot) const { return slot < boxes_.second ? 0 : 1; }

  // What a pair shares lies in the bounds of both sets. False when these have nothing in common.
  bool find_space() {
    const Aabb one = bounds_of(sets_[0]);
    const Aabb other = bounds_of(sets_[1]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      space_.min[axis] = std::max(one.min[axis], other.min[axis]);
      space_.max[axis] = std::min(one.max[axis], other.max[axis]);
    }
    return overlap(one, other);
  }

  // Whether, of a few boxes, most have none of the other set nearby: as the grid would say, but asked of all
  // others. Where sets lie mixed one is soon found.
  bool are_most_alone(const CoarseGrid& grid) const {
    const bool are_many = boxes_.boxes.size() >= tuning::kManyAsked;
    const unsigned most_near = are_many ? tuning::kNearOfMany : tuning::kNearOfFew;
    const BoxLanes space(space_);
    unsigned alone = 0;
    unsigned near = 0;
    for (std::size_t i = 0; i < kVisited; ++i) {
      const std::size_t slot = visited(i);
      const BoxLanes box(boxes_.boxes[slot]);
      if (!overlap(box, space)) continue;
      const BoxLanes around = grid.around(box);
      const bool is_near = std::ranges::any_of(
          sets_[1 - set_of(slot)], [&](const Aabb& other) { return overlap(around, BoxLanes(other)); });
      ++(is_near ? near : alone);
      if (near == most_near) return false;
      if (alone == tuning::kAloneOfAsked) return true;
    }
    return alone > near;
  }

  bool are_some_outside() const {
    const BoxLanes space(space_);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < kVisited; ++i)
      outside += overlap(BoxLanes(boxes_.boxes[visited(i)]), space) ? 0 : 1;
    return outside > kVisited / kWorthIt;
  }

  /// All over both sets, whatever the order that boxes are in: steps of the golden section.
  std::size_t visited(std::size_t i) const {
    constexpr std::uint64_t kGoldenSection = 0x9e3779b97f4a7c15;
    const std::uint64_t place = (i * kGoldenSection) >> 32;
    return static_cast<std::size_t>((place * boxes_.boxes.size()) >> 32);
  }

  void list_inside() {
    const BoxLanes space(space_);
    for (std::size_t set = 0; set < 2; ++set) {
      Array<std::uint32_t>& listed = listed_[set];
      listed.renew(sets_[set].size());
      for (std::uint32_t i = 0; i < listed.size(); ++i) listed.data()[i] = i;
      keep_those(set, [&](const BoxLanes& box) { return overlap(box, space); });
    }
  }

  // First those of the larger set, and of the smaller one by what is left of it. Gives up where boxes are too
  // large.
  void leave_out_alone(const CoarseGrid& grid) {
    const std::size_t smaller = sets_[0].size() < sets_[1].size() ? 0 : 1;
    cells_.renew(1);
    for (const std::size_t set : {smaller, 1 - smaller}) {
      if (!mark(grid, set)) return;
      const CoarseCells& cells = *cells_.data();
      const auto meets = [&](std::size_t row, std::uint64_t bits) { return (cells[row] & bits) != 0; };
      keep_those(1 - set, [&](const BoxLanes& box) { return grid.any_row(box, meets); });
    }
  }

  // The cells that the listed boxes of a set reach into. False when they are too large.
  bool mark(const CoarseGrid& grid, std::size_t set) {
    CoarseCells& cells = *cells_.data();
    cells.fill(0);
    const std::uint64_t most = tuning::kRowsOfApart * boxes_.boxes.size();
    std::uint64_t rows = 0;
    for (const std::uint32_t i : listed_[set].view()) {
      grid.any_row(BoxLanes(sets_[set][i]), [&](std::size_t row, std::uint64_t bits) {
        cells[row] |= bits;
        ++rows;
        return false;
      });
      if (rows > most) return false;
    }
    return true;
  }

  /// Of those listed.
  template <class Is>
  void keep_those(std::size_t set, const Is& is) {
    std::uint32_t* to = listed_[set].data();
    for (const std::uint32_t i : listed_[set].view()) {
      *to = i;
      to += is(BoxLanes(sets_[set][i])) ? 1 : 0;
    }
    listed_[set].shrink(static_cast<std::size_t>(to - listed_[set].data()));
  }

  void keep_listed() {
    const std::size_t all = boxes_.boxes.size();
    const std::size_t kept = listed_[0].size() + listed_[1].size();
    if (kept > all - all / kWorthIt) return;
    Array<std::uint32_t> places;
    places.renew(kept);
    std::uint32_t* to = std::ranges::copy(listed_[0].view(), places.data()).out;
    for (const std::uint32_t i : listed_[1].view()) *to++ = boxes_.second + i;
    for (std::size_t slot = 0; slot < kept; ++slot)
      boxes_.own.data()[slot] = boxes_.boxes[places.data()[slot]];
    boxes_.second = static_cast<std::uint32_t>(listed_[0].size());
    boxes_.boxes = boxes_.boxes.first(kept);
    boxes_.places = std::move(places);
  }

  SearchedBoxes& boxes_;
  std::array<std::span<const Aabb>, 2> sets_;
  std::array<Array<std::uint32_t>, 2> listed_;  // places in them, ascending
  Aabb space_;
  Array<CoarseCells> cells_;  // one, too large for the stack
};

}  // namespace

void leave_out_apart(SearchedBoxes& boxes) {
  if (boxes.second == 0 || boxes.second == boxes.boxes.size()) return;
  Apart(boxes).leave_out();
}

}  // namespace cellsweep::one_shot
