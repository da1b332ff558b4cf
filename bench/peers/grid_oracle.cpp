#include "bench/peers/grid_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace cellsweep::bench {
namespace {

using Cell = std::array<std::uint32_t, 3>;

double longest_edge(const Aabb& box) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, static_cast<double>(box.max[k]) - static_cast<double>(box.min[k]));
  }
  return longest;
}

/// Even cells over all boxes.
class Grid {
 public:
  explicit Grid(std::span<const Aabb> boxes) {
    std::array<double, 3> top{};
    low_.fill(std::numeric_limits<double>::max());
    top.fill(std::numeric_limits<double>::lowest());
    double edges = 0;
    for (const Aabb& box : boxes) {
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], static_cast<double>(box.min[k]));
        top[k] = std::max(top[k], static_cast<double>(box.max[k]));
      }
      edges += longest_edge(box);
    }
    const auto count = static_cast<double>(boxes.size());
    double volume = 1;
    for (std::size_t k = 0; k < 3; ++k) volume *= std::max(top[k] - low_[k], 1e-30);
    // Half as large again as the mean box, and about one cell for each.
    edge_ = std::max({1.5 * edges / count, std::cbrt(volume / count), 1e-30});
    while (cells_up_to(top) > kMostCellsPerBox * count) edge_ *= 1.5;
    for (std::size_t k = 0; k < 3; ++k) cells_[k] = place(top[k], k) + 1;
  }

  Cell cell_of(const std::array<float, 3>& corner) const {
    return {place(corner[0], 0), place(corner[1], 1), place(corner[2], 2)};
  }

  std::size_t index(const Cell& cell) const {
    return (std::size_t{cell[2]} * cells_[1] + cell[1]) * cells_[0] + cell[0];
  }

  std::size_t size() const { return std::size_t{cells_[0]} * cells_[1] * cells_[2]; }

 private:
  static constexpr double kMostCellsPerBox = 8;

  double cells_up_to(const std::array<double, 3>& top) const {
    double cells = 1;
    for (std::size_t k = 0; k < 3; ++k) cells *= std::floor((top[k] - low_[k]) / edge_) + 1;
    return cells;
  }

  // Never decreases with the coordinate: all that exactness needs.
  std::uint32_t place(double coordinate, std::size_t axis) const {
    return static_cast<std::uint32_t>((coordinate - low_[axis]) / edge_);
  }

  std::array<double, 3> low_{};
  std::array<std::uint32_t, 3> cells_{};
  double edge_ = 1;
};

/// The ids of the boxes in each cell, one after the other.
struct Entries {
  std::vector<std::size_t> ends;  ///< of cell i; it begins where i − 1 ends
  std::vector<BodyId> ids;
};

template <class Visit>
void for_each_cell(const Grid& grid, const Aabb& box, Visit&& visit) {
  const Cell first = grid.cell_of(box.min);
  const Cell last = grid.cell_of(box.max);
  for (std::uint32_t z = first[2]; z <= last[2]; ++z) {
    for (std::uint32_t y = first[1]; y <= last[1]; ++y) {
      for (std::uint32_t x = first[0]; x <= last[0]; ++x) visit(grid.index({x, y, z}));
    }
  }
}

Entries enter_all(const Grid& grid, std::span<const Aabb> boxes) {
  Entries entries;
  entries.ends.assign(grid.size() + 1, 0);
  for (const Aabb& box : boxes) {
    for_each_cell(grid, box, [&](std::size_t cell) { ++entries.ends[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < grid.size(); ++cell) entries.ends[cell + 1] += entries.ends[cell];
  entries.ids.resize(entries.ends.back());
  // Each start moves on to its end.
  for (std::size_t id = 0; id < boxes.size(); ++id) {
    for_each_cell(grid, boxes[id],
                  [&](std::size_t cell) { entries.ids[entries.ends[cell]++] = static_cast<BodyId>(id); });
  }
  entries.ends.pop_back();
  return entries;
}

// Of the cells that both boxes reach into, the one with the lower corner of what they share.
std::size_t home_of(const Grid& grid, const Aabb& a, const Aabb& b) {
  return grid.index(grid.cell_of(
      {std::max(a.min[0], b.min[0]), std::max(a.min[1], b.min[1]), std::max(a.min[2], b.min[2])}));
}

void compare_in_cell(const Grid& grid, std::span<const Aabb> boxes, std::size_t cell,
                     std::span<const BodyId> ids, std::vector<Pair>& pairs) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Aabb& box = boxes[ids[i]];
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      const Aabb& other = boxes[ids[j]];
      if (overlap(box, other) && home_of(grid, box, other) == cell) {
        pairs.push_back(make_pair_of(ids[i], ids[j]));
      }
    }
  }
}

void append_grid_pairs(std::span<const Aabb> boxes, std::vector<Pair>& pairs) {
  if (boxes.empty()) return;
  const Grid grid(boxes);
  const Entries entries = enter_all(grid, boxes);
  std::size_t start = 0;
  for (std::size_t cell = 0; cell < entries.ends.size(); ++cell) {
    const std::size_t end = entries.ends[cell];
    compare_in_cell(grid, boxes, cell, std::span(entries.ids).subspan(start, end - start), pairs);
    start = end;
  }
}

// All bodies, the few with the longest boxes first: beside a plane that is far larger than the world, cells
// of any even size would hold all others or be too many.
std::vector<BodyId> largest_first(std::span<const Aabb> boxes, std::size_t few) {
  std::vector<BodyId> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  std::partial_sort(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(few), ids.end(),
                    [&](BodyId a, BodyId b) { return longest_edge(boxes[a]) > longest_edge(boxes[b]); });
  return ids;
}

}  // namespace

std::vector<Pair> grid_pairs(std::span<const Aabb> boxes) {
  constexpr std::size_t kLargest = 4;
  const std::size_t few = std::min(kLargest, boxes.size());
  const std::vector<BodyId> ids = largest_first(boxes, few);
  std::vector<Aabb> rest;
  for (std::size_t i = few; i < ids.size(); ++i) rest.push_back(boxes[ids[i]]);
  std::vector<Pair> pairs;
  append_grid_pairs(rest, pairs);
  for (Pair& pair : pairs) pair = make_pair_of(ids[few + pair.a], ids[few + pair.b]);
  for (std::size_t i = 0; i < few; ++i) {
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      if (overlap(boxes[ids[i]], boxes[ids[j]])) pairs.push_back(make_pair_of(ids[i], ids[j]));
    }
  }
  return pairs;
}

}  // namespace cellsweep::bench
