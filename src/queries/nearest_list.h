/// @file
/// The nearest bodies so far, at most so many.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "cellsweep/query.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {

/// Keeps the first `count` of all that are offered by (distance, body), none beyond `most`. The caller's
/// vector is the memory: a heap with the last one on top, until sort().
class NearestList {
 public:
  NearestList(std::size_t count, double most, std::vector<Neighbor>& found)
      : count_(count), most_(most), found_(found) {
    found_.clear();
  }

  /// Nothing that is further can be one of them.
  double most() const { return count_ == 0 ? -1 : most_; }

  /// How many it takes whatever their distance, up to most().
  std::size_t room() const { return count_ - found_.size(); }

  bool takes(const Neighbor& neighbor) const {
    if (!(neighbor.distance <= most())) return false;
    return found_.size() < count_ || Nearer()(neighbor, found_.front());
  }

  /// One that it takes().
  void add(const Neighbor& neighbor) {
    if (found_.size() == count_) {
      std::ranges::pop_heap(found_, Nearer());
      found_.back() = neighbor;
    } else {
      found_.push_back(neighbor);
    }
    std::ranges::push_heap(found_, Nearer());
    if (found_.size() == count_) most_ = found_.front().distance;
  }

  void sort() { sort_neighbors(found_); }

 private:
  std::size_t count_;
  double most_;
  std::vector<Neighbor>& found_;
};

}  // namespace cellsweep::queries
