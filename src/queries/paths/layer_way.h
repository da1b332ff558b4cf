/// @file
/// A path on one axis of a grid, counted in its layers of cells: 2.5 is half way through the third one.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engines/stream/kernels/kernel.h"
#include "queries/arithmetic.h"

namespace cellsweep::queries {

/// A part of a path's time.
struct Interval {
  double from = 0;
  double to = 0;
};

/// A path on one axis of the world.
struct AxisWay {
  double low = 0;  ///< where it begins
  double high = 0;
  double direction = 0;
  double inverse = 0;  ///< of the direction; 0 when it stays, or is too slow to say when it is where

  AxisWay() = default;
  AxisWay(const Cast::Axis& axis, double end)
      : low(axis.low), high(axis.high), direction(axis.direction), inverse(axis.inverse) {
    if (inverse != 0) return;
    const double way = direction == 0 ? 0 : direction * end;
    low += std::min(way, 0.0);
    high += std::max(way, 0.0);
    direction = 0;
  }
};

/// Never less of the path, nor less time, than there is. A grid puts a coordinate into a layer in floats,
/// with an error of less than 2^-22 of the way from its origin; coordinates themselves are rounded to floats,
/// by less than 2^-23; and what is computed here is off by some 2^-50.
class LayerWay {
 public:
  LayerWay() = default;
  LayerWay(const AxisWay& way, const stream::GridNumbers& grid, unsigned axis)
      : top_(static_cast<std::uint32_t>(grid.top[axis])) {
    const double origin = grid.origin[axis];
    const double scale = grid.scale[axis];
    low_ = (way.low - origin) * scale;
    high_ = (way.high - origin) * scale;
    speed_ = way.direction * scale;
    if (way.inverse != 0 && top_ != 0) inverse_ = 1 / speed_;
    slack_ = (std::fabs(origin) + FLT_MIN) * scale * kFloatSlack +
             std::max(std::fabs(low_), std::fabs(high_)) * kSlack;
    top_from_ = std::min<double>(top_, FLT_MAX * scale * (1 - kFloatSlack));
  }

  std::uint32_t top() const { return top_; }
  bool goes_up() const { return speed_ > 0; }
  bool stays() const { return inverse_ == 0; }
  /// Layers in a unit of time.
  double layers() const { return std::fabs(speed_); }

  /// The first and the last layer in which it is during some time.
  std::uint32_t lowest(const Interval& time) const {
    const double way = way_in(goes_up() ? time.from : time.to);
    const double layer = low_ + way;
    const double least = layer - slack_of(layer, way);
    return least > 0 ? static_cast<std::uint32_t>(std::min<double>(least, top_)) : 0;
  }
  std::uint32_t highest(const Interval& time) const {
    const double way = way_in(goes_up() ? time.to : time.from);
    const double layer = high_ + way;
    const double most = layer + slack_of(layer, way);
    if (most >= top_from_) return top_;
    return most > 0 ? static_cast<std::uint32_t>(most) : 0;
  }

  /// When it comes to a layer and when it leaves it; not if it stays.
  double enters(std::uint32_t layer) const {
    return goes_up() ? earlier(to_low_side(layer) - high_) : earlier(to_high_side(layer) - low_);
  }
  double leaves(std::uint32_t layer) const {
    return goes_up() ? later(to_high_side(layer) - low_) : later(to_low_side(layer) - high_);
  }

 private:
  static constexpr double kFloatSlack = 0x1p-20;
  static constexpr double kSlack = 0x1p-47;

  double way_in(double time) const { return speed_ == 0 ? 0 : speed_ * time; }
  double slack_of(double layer, double way) const {
    return slack_ + std::fabs(layer) * kFloatSlack + std::fabs(way) * kSlack;
  }
  // Everything below the first layer is in it, and everything above the last.
  double to_low_side(std::uint32_t layer) const {
    if (layer == 0) return -HUGE_VAL;
    const double side = layer == top_ ? top_from_ : layer;
    return side - side * kFloatSlack - slack_;
  }
  double to_high_side(std::uint32_t layer) const {
    if (layer == top_) return HUGE_VAL;
    const double side = layer + 1;
    return side + side * kFloatSlack + slack_;
  }
  double earlier(double way) const {
    const double time = way * inverse_;
    return time - std::fabs(time) * kSlack;
  }
  double later(double way) const {
    const double time = way * inverse_;
    return time + std::fabs(time) * kSlack;
  }

  double low_ = 0;
  double high_ = 0;
  double speed_ = 0;
  double inverse_ = 0;  // of the speed; 0: stays()
  double slack_ = 0;
  double top_from_ = 0;
  std::uint32_t top_ = 0;
};

}  // namespace cellsweep::queries
