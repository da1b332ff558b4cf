/// @file
/// What users of trees in floats do with the boxes that a tree names.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "cellsweep/query.h"

namespace cellsweep::bench {

/// A ray in floats, with the inverse of its direction: where that is 0, a large number, as Bullet has it.
struct FloatRay {
  std::array<float, 3> origin{};
  std::array<float, 3> inverse{};
  float end = 0;

  explicit FloatRay(const Ray& ray) : origin(ray.origin), end(static_cast<float>(ray.end)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto d = static_cast<float>(ray.direction[k]);
      inverse[k] = d == 0 ? 1e18F : 1 / d;
    }
  }

  /// When the ray enters a box, 0 where it begins in it; infinity where it does not up to its end.
  float enters(const float* low, const float* high) const {
    float enter = 0;
    float leave = end;
    for (std::size_t k = 0; k < 3; ++k) {
      const float a = (low[k] - origin[k]) * inverse[k];
      const float b = (high[k] - origin[k]) * inverse[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<float>::infinity();
  }
};

/// The square of the distance of a point from a box.
inline float square_of_distance(const Point& point, const float* low, const float* high) {
  float square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float gap = std::max({low[k] - point[k], point[k] - high[k], 0.0F});
    square += gap * gap;
  }
  return square;
}

/// The nearest so far: a heap by distance, the furthest on top. Distances are squares until finish().
class NearestHeap {
 public:
  NearestHeap(std::size_t count, std::vector<Neighbor>& found) : count_(count), found_(found) {
    found_.clear();
  }

  float most() const { return most_; }

  void offer(BodyId body, float square) {
    if (!(square < most_)) return;
    if (found_.size() == count_) {
      std::pop_heap(found_.begin(), found_.end(), is_nearer);
      found_.back() = {body, square};
    } else {
      found_.push_back({body, square});
    }
    std::push_heap(found_.begin(), found_.end(), is_nearer);
    if (found_.size() == count_) most_ = static_cast<float>(found_.front().distance);
  }

  /// The nearest first.
  void finish() {
    std::sort_heap(found_.begin(), found_.end(), is_nearer);
    for (Neighbor& neighbor : found_) neighbor.distance = std::sqrt(neighbor.distance);
  }

 private:
  static bool is_nearer(const Neighbor& one, const Neighbor& other) { return one.distance < other.distance; }

  std::size_t count_;
  std::vector<Neighbor>& found_;
  float most_ = std::numeric_limits<float>::infinity();
};

}  // namespace cellsweep::bench
