/// @file
/// A path in floats, for kernels.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "queries/arithmetic.h"
#include "queries/kernels/kernel.h"
#include "queries/outward.h"

namespace cellsweep::queries {

/// A path's numbers for kernels, and how their time is counted.
class PathNumbers {
 public:
  explicit PathNumbers(const Cast& cast) : scale_(scale_of(cast)) {
    numbers_.is_flat = false;
    for (std::size_t axis = 0; axis < 3; ++axis) set_axis(cast.axis(axis), axis);
    if (numbers_.is_flat) set_flat(cast);
    end(cast.end());
  }

  const CastNumbers& numbers() const { return numbers_; }

  void end(double time) {
    const double scaled = time * scale_;
    numbers_.end = scaled > kFarthest ? kInfinity : above(scaled);
  }

 private:
  static constexpr double kFarthest = 1e38;
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  // The largest power of two that is not above the largest component; of small ones, about it.
  static double scale_of(const Cast& cast) {
    constexpr double kSmall = 0x1p-1000;
    const double largest =
        std::max(std::max(std::fabs(cast.axis(0).direction), std::fabs(cast.axis(1).direction)),
                 std::max(std::fabs(cast.axis(2).direction), kSmall));
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) >> 52 << 52);
  }

  void set_axis(const Cast::Axis& path, std::size_t axis) {
    constexpr double kMostInverse = 0x1p60;
    const double inverse = path.inverse * scale_;
    const bool is_flat = inverse == 0 || std::fabs(inverse) > kMostInverse;
    numbers_.near[axis] = static_cast<unsigned>(path.near);
    numbers_.front[axis] = static_cast<float>(path.front);
    numbers_.back[axis] = static_cast<float>(path.back);
    numbers_.inverse[axis] = is_flat ? 0 : static_cast<float>(inverse);
    numbers_.is_flat = numbers_.is_flat || is_flat;
  }

  [[gnu::cold]] void set_flat(const Cast& cast) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      numbers_.wide[axis] = 0;
      numbers_.low[axis] = -kInfinity;
      numbers_.high[axis] = kInfinity;
      if (numbers_.inverse[axis] == 0) set_flat_axis(cast.axis(axis), cast.end(), axis);
    }
  }

  void set_flat_axis(const Cast::Axis& path, double end, std::size_t axis) {
    const double way = path.direction == 0 ? 0 : path.direction * end;
    numbers_.wide[axis] = kInfinity;
    numbers_.low[axis] = way == 0 ? path.low : below(path.low + std::min(way, 0.0));
    numbers_.high[axis] = way == 0 ? path.high : above(path.high + std::max(way, 0.0));
  }

  double scale_;         // times in lengths of the scaled direction are so many times as large
  CastNumbers numbers_;  // NOLINT(*-member-init): all that is read is set by the constructor
};

}  // namespace cellsweep::queries
