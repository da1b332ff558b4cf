/// @file
/// Sets of boxes for the tests of one-shot searches, and who overlaps in them by comparing all with all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cellsweep/find_pairs.h"

namespace cellsweep::one_shot {

/// Boxes of doubles, of one of the families below.
struct DoubleKind {
  const char* name;
  std::vector<Box<double, 3>> (*make)(std::size_t count, std::uint64_t seed);
};
const std::vector<DoubleKind>& double_kinds();

/// Every number may be told apart from the next: floats would not do.
std::vector<Box<double, 3>> two_tiny_clusters(std::size_t count, std::uint64_t seed);

/// The faces of the first `kAxes` axes.
template <class Number, std::size_t kAxes, class AnyBox>
std::vector<Box<Number, kAxes>> cut_to(const std::vector<AnyBox>& boxes) {
  std::vector<Box<Number, kAxes>> cut(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      cut[i].min[axis] = static_cast<Number>(boxes[i].min[axis]);
      cut[i].max[axis] = static_cast<Number>(boxes[i].max[axis]);
    }
  }
  return cut;
}

template <class AnyBox>
bool touch(const AnyBox& one, const AnyBox& other) {
  for (std::size_t axis = 0; axis < one.min.size(); ++axis) {
    if (one.min[axis] > other.max[axis] || other.min[axis] > one.max[axis]) return false;
  }
  return true;
}

template <class AnyBox>
std::vector<Pair> true_pairs(const std::vector<AnyBox>& boxes) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (touch(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

template <class AnyBox>
std::vector<CrossPair> true_pairs(const std::vector<AnyBox>& a, const std::vector<AnyBox>& b) {
  std::vector<CrossPair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (touch(a[i], b[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

}  // namespace cellsweep::one_shot
