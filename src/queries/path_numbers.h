/// @file
/// A path in floats, for kernels.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "cellsweep/query.h"
#include "geometry/canonical.h"
#include "queries/arithmetic.h"
#include "queries/kernels/kernel.h"
#include "queries/outward.h"

namespace cellsweep::queries {

/// A path's numbers for kernels, and how their time is counted.
class PathNumbers {
 public:
  explicit PathNumbers(const Path& path) : scale_(2 * power_of_two(largest_component(path))) {
    const double inverse_scale = inverse_of_power(scale_);
    numbers_.goes_down = 0;
    numbers_.is_flat = false;
    numbers_.can_be_certain = true;
    for (unsigned axis = 0; axis < 3; ++axis) set_axis(path, inverse_scale, axis);
    if (numbers_.is_flat) set_flat(path);
    end(path.end);
    numbers_.certain_end = below(std::min(path.end * scale_, kFarthest));
  }

  const CastNumbers& numbers() const { return numbers_; }

  void end(double time) {
    const double scaled = time * scale_;
    numbers_.end = scaled > kFarthest ? kInfinity : above(scaled);
  }

 private:
  static constexpr double kFarthest = 1e38;
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  static double largest_component(const Path& path) {
    constexpr double kSmall = 0x1p-1000;
    const auto& [x, y, z] = path.direction;
    return std::max(std::max(std::fabs(x), std::fabs(y)), std::max(std::fabs(z), kSmall));
  }
  // The largest one that is not above the number.
  static double power_of_two(double number) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) >> 52 << 52);
  }
  static double inverse_of_power(double power) {
    constexpr std::uint64_t kOneTwice = std::uint64_t{2046} << 52;  // the bits of 1, exponents added
    return std::bit_cast<double>(kOneTwice - std::bit_cast<std::uint64_t>(power));
  }

  void set_axis(const Path& path, double inverse_scale, unsigned axis) {
    constexpr float kLeast = 0x1p-60F;
    const double direction = path.direction[axis];
    const float scaled = static_cast<float>(direction * inverse_scale);
    const bool is_flat = std::fabs(scaled) < kLeast || !Cast::has_inverse(direction);
    const unsigned goes_down = !is_flat && scaled < 0 ? 1 : 0;
    const float sides[2] = {canonical(path.box.max[axis]), canonical(path.box.min[axis])};
    numbers_.goes_down |= goes_down << axis;
    numbers_.front[axis] = sides[goes_down];
    numbers_.back[axis] = sides[1 - goes_down];
    numbers_.inverse[axis] = is_flat ? 0 : 1 / scaled;
    numbers_.is_flat = numbers_.is_flat || is_flat;
    numbers_.can_be_certain = numbers_.can_be_certain && (!is_flat || direction == 0);
  }

  [[gnu::cold]] void set_flat(const Path& path) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      numbers_.wide[axis] = 0;
      numbers_.low[axis] = -kInfinity;
      numbers_.high[axis] = kInfinity;
      if (numbers_.inverse[axis] == 0) set_flat_axis(path, axis);
    }
  }

  void set_flat_axis(const Path& path, unsigned axis) {
    const double direction = path.direction[axis];
    const double way = direction == 0 ? 0 : direction * path.end;
    const float high = numbers_.front[axis];
    const float low = numbers_.back[axis];
    numbers_.wide[axis] = kInfinity;
    numbers_.low[axis] = way == 0 ? low : below(reach(low, way < 0 ? way : -0.0));
    numbers_.high[axis] = way == 0 ? high : above(reach(high, way > 0 ? way : 0.0));
  }

  // How far it comes from there, and a little further: a small sum of large numbers is as uncertain as they
  // are.
  static double reach(double from, double way) {
    const double slack = 0x1p-48 * (std::fabs(from) + std::fabs(way));
    return from + way + std::copysign(slack, way);
  }

  double scale_;         // times in lengths of the scaled direction are so many times as large
  CastNumbers numbers_;  // NOLINT(*-member-init): all that is read is set by the constructor
};

}  // namespace cellsweep::queries
