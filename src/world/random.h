/// @file
/// The project's own random numbers (splitmix64): the same seed gives the same numbers everywhere (W4).
#pragma once

#include <cstdint>

#include "cellsweep/pair.h"

namespace cellsweep {

/// A stream of random numbers; the standard library's distributions differ between implementations, these
/// not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// A stream of its own for every (seed, index): neighbouring ones share no numbers.
  Random(std::uint64_t seed, std::uint64_t index)
      : state_(mix64(mix64(seed + kGamma) + (index + 1) * kGamma)) {}

  std::uint64_t next() {
    state_ += kGamma;
    return mix64(state_);
  }

  /// 0 <= x < 1, in steps of 2^-53.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// 0 < x <= 1.
  double positive_unit() { return 1.0 - unit(); }

  double between(double low, double high) { return low + (high - low) * unit(); }

  /// 0 <= x < bound, for bounds from 1 to 2^32; the bias, bound / 2^32 at most, is of no matter to a scene.
  std::uint64_t below(std::uint64_t bound) { return ((next() >> 32) * bound) >> 32; }

 private:
  static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ULL;

  std::uint64_t state_;
};

}  // namespace cellsweep
