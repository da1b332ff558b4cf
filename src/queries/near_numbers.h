/// @file
/// A box and a distance in floats, for kernels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "cellsweep/aabb.h"
#include "queries/kernels/kernel.h"

namespace cellsweep::queries {

/// Larger ones may be none in floats.
inline constexpr double kLargestSquare = 1e37;

/// NearNumbers::most. Kernels compute squares in floats, off by less than 2^-21 of them, or, of tiny ones, by
/// less than 1e-37.
inline float square_above(double distance) {
  const double square = distance * distance;
  return square > kLargestSquare ? std::numeric_limits<float>::infinity()
                                 : static_cast<float>(square * (1 + 0x1p-18)) + 1e-37F;
}

/// NearNumbers::certain. What floats cut off at their lower end counts for nothing where the distance is not
/// tiny.
inline float certain_square(double distance) {
  constexpr double kTiny = 1e-30;
  const double square = std::min(distance * distance, kLargestSquare);
  return square < kTiny ? -1.0F : static_cast<float>(square * (1 - 0x1p-16));
}

inline NearNumbers near_numbers(const Aabb& box, double distance) {
  NearNumbers numbers{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    numbers.min[axis] = box.min[axis];
    numbers.max[axis] = box.max[axis];
  }
  numbers.most = square_above(distance);
  numbers.certain = certain_square(distance);
  return numbers;
}

}  // namespace cellsweep::queries
