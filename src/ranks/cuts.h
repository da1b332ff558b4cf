/// @file
/// The regions that the world is cut into, one for each rank, and which of them a box reaches.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "ranks/region.h"

namespace cellsweep::ranks {

/// Regions that share no point and leave none out. A tree over ranges of ranks, which bisection puts beside
/// each other, finds those that a box reaches.
class Cuts {
 public:
  /// All of space is rank 0's.
  explicit Cuts(int ranks);
  explicit Cuts(std::vector<Region> regions);

  const Region& region(int rank) const { return regions_[static_cast<std::size_t>(rank)]; }

  /// Overwrites `ranks` with those whose region the box reaches, ascending.
  void find_reached(const Aabb& box, std::vector<int>& ranks) const;
  /// The same of a path: all ranks where it may touch a body, and perhaps one more.
  void find_reached(const Path& path, std::vector<int>& ranks) const;
  /// The rank whose region holds the point.
  int home_of(const Point& point) const;

 private:
  struct Range {
    std::size_t first;
    std::size_t last;
    std::size_t node;

    bool is_leaf() const { return last - first == 1; }
    Range lower() const { return {first, first + (last - first) / 2, 2 * node + 1}; }
    Range upper() const { return {first + (last - first) / 2, last, 2 * node + 2}; }
  };

  Range all() const { return {0, regions_.size(), 0}; }
  const Region& bound(const Range& range);
  template <class IsWanted, class Visit>
  void visit(const Range& range, const IsWanted& is_wanted, const Visit& visit_rank) const;

  std::vector<Region> regions_;
  std::vector<Region> bounds_;  // of ranges of ranks: halves of node n are 2n + 1 and 2n + 2
};

}  // namespace cellsweep::ranks
