/// @file
/// Where the layers of a grid's cells lie on an axis: never less than where their coordinates are.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::queries {

/// A Grid puts a coordinate into a layer in floats, with an error of less than 2^-22 of the way from the
/// grid's origin, and a layer that is found for a number between two floats may be that of the lower one.
class Layers {
 public:
  Layers() = default;
  Layers(const stream::GridNumbers& grid, unsigned axis)
      : origin_(grid.origin[axis]),
        width_(1 / double{grid.scale[axis]}),
        top_(static_cast<std::uint32_t>(grid.top[axis])) {}

  std::uint32_t top() const { return top_; }

  /// No coordinate of the layer is below this.
  double low(std::uint32_t layer) const {
    if (layer == 0) return -kInfinity;
    const double way = layer * width_;
    const double low = origin_ + way - slack(way);
    // From further away than floats go, all is taken to be in the last layer.
    return layer == top_ ? std::fmin(low, origin_ + FLT_MAX) : low;
  }
  /// Nor above this.
  double high(std::uint32_t layer) const {
    if (layer == top_) return kInfinity;
    const double way = (layer + 1) * width_;
    return origin_ + way + slack(way);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double slack(double way) const { return (std::fabs(origin_) + way) * 0x1p-21 + FLT_MIN; }

  double origin_ = 0;
  double width_ = 0;
  std::uint32_t top_ = 0;
};

}  // namespace cellsweep::queries
