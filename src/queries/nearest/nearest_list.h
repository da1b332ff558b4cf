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
/// vector is the memory: a heap with the last one on top, until sort(), or a few in order.
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
    return found_.size() < count_ || Nearer()(neighbor, last());
  }

  /// One that it takes().
  void add(const Neighbor& neighbor) {
    if (found_.size() < count_) {
      found_.emplace_back();
    } else if (!are_few()) {
      std::ranges::pop_heap(found_, Nearer());
    }
    put_last(neighbor);
    if (found_.size() == count_) most_ = last().distance;
  }

  void sort() {
    if (!are_few()) sort_neighbors(found_);
  }

 private:
  /// To keep so many in order takes less than a heap.
  static constexpr std::size_t kFew = 16;

  bool are_few() const { return count_ <= kFew; }
  const Neighbor& last() const { return are_few() ? found_.back() : found_.front(); }

  // The last place of the list is free: in it, and from there on to where the neighbor belongs.
  void put_last(const Neighbor& neighbor) {
    if (!are_few()) {
      found_.back() = neighbor;
      std::ranges::push_heap(found_, Nearer());
      return;
    }
    std::size_t place = found_.size() - 1;
    for (; place > 0 && Nearer()(neighbor, found_[place - 1]); --place) found_[place] = found_[place - 1];
    found_[place] = neighbor;
  }

  std::size_t count_;
  double most_;
  std::vector<Neighbor>& found_;
};

}  // namespace cellsweep::queries
