/// @file
/// Boxes of doubles: searched as boxes of floats around them, tested as they are.
#pragma once

#include <span>

#include "base/memory/array.h"
#include "one_shot/box_set.h"

namespace cellsweep::one_shot {

/// Closed boxes.
inline bool overlap(const ExactBox& one, const ExactBox& other) {
  bool all = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all &= one.min[axis] <= other.max[axis];
    all &= other.min[axis] <= one.max[axis];
  }
  return all;
}

/// Floats around the doubles, from a point in the middle of them on: near 0 floats are close to each other.
/// Boxes that overlap do so as floats, too; of others some may.
void make_rounded(std::span<const ExactBox> exact, Array<Aabb>& rounded);

/// The same with each coordinate replaced by its place in the order of all on its axis: up to 2^23 boxes
/// overlap then only where they do. Takes some ten times as long.
void make_ranked(std::span<const ExactBox> exact, Array<Aabb>& ranked);

}  // namespace cellsweep::one_shot
