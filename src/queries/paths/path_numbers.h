/// @file
/// A path in floats, for kernels.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cellsweep/query.h"
#include "geometry/box_lanes.h"
#include "queries/arithmetic.h"
#include "queries/kernels/kernel.h"
#include "queries/outward.h"

namespace cellsweep::queries {

/// A path's numbers for kernels, and how their time is counted. A walk waits for them: what it takes is how
/// many operations follow each other, of which there are few, and nearly all for three axes at a time.
class PathNumbers {
 public:
  explicit PathNumbers(const Path& path) {
    const double largest = largest_component(path);
    Float4 direction = floats_of(path, 1);
    float scale = kUsualScale;
    // A branch: else everything would wait for the largest component.
    if (largest < 1 / kUsualScale || largest > kUsualScale) scale = use_scale(path, largest, direction);
    const Int4 flat = magnitude(direction) < kLeast * scale;
    numbers_.can_be_certain = true;
    numbers_.is_flat = on_any_axis(flat) || largest < kAllHaveInverses;
    // A branch: else all divisions would wait for what is flat.
    if (numbers_.is_flat) direction = reinterpret_cast<Float4>(reinterpret_cast<Int4>(direction) & ~flat);
    const BoxLanes box(BoxNumbers::just_written(path.box));
    set_axes(box, direction, scale);
    if (numbers_.is_flat) set_flat(path, flat);
    end(path.end);
    numbers_.certain_end = below(std::min(path.end * scale_, kFarthest));
  }

  const CastNumbers& numbers() const { return numbers_; }

  // above() of it, in as few steps: a walk waits for each end.
  void end(double time) {
    const double later = time * scale_above_ + FLT_MIN;
    numbers_.end = later > kFarthest ? kInfinity : static_cast<float>(later);
  }

 private:
  static constexpr double kFarthest = 1e38;
  static constexpr double kAbove = 1 + 0x1p-22;
  static constexpr std::int32_t kFace = TreeNode::kFaceBytes;
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();
  /// The least component of a scaled direction along which a path moves.
  static constexpr float kLeast = 0x1p-60F;
  /// Where the largest component is no less, another one that has no inverse is scaled to less than kLeast.
  static constexpr double kAllHaveInverses = 0x1p-400;

  /// Directions between this and its inverse become times that are so many times as large without being
  /// scaled themselves.
  static constexpr float kUsualScale = 0x1p16F;

  static Float4 floats_of(const Path& path, double scale) {
    const auto& [x, y, z] = path.direction;
    return Float4{static_cast<float>(x * scale), static_cast<float>(y * scale), static_cast<float>(z * scale),
                  1};
  }

  // Of another direction. Returns by what the scaled one is to be divided once more.
  [[gnu::cold, gnu::noinline]] float use_scale(const Path& path, double largest, Float4& direction) {
    const Scale scale(largest);
    scale_ = scale.factor;
    scale_above_ = scale.factor * kAbove;
    direction = floats_of(path, scale.inverse);
    return 1;
  }

  static double largest_component(const Path& path) {
    constexpr double kSmall = 0x1p-1000;
    const auto& [x, y, z] = path.direction;
    return std::max(std::max(std::fabs(x), std::fabs(y)), std::max(std::fabs(z), kSmall));
  }

  /// The power of two above a number, made of its bits without a way through other registers.
  struct Scale {
    explicit Scale(double number) {
      using Long2 [[gnu::vector_size(16)]] = std::int64_t;
      using Double2 [[gnu::vector_size(16)]] = double;
      constexpr std::int64_t kExponent = std::int64_t{0x7ff} << 52;
      constexpr std::int64_t kTwice = std::int64_t{1} << 52;
      constexpr std::int64_t kOneTwice = std::int64_t{2046} << 52;  // the bits of 1, exponents added
      const Long2 power = (reinterpret_cast<Long2>(Double2{number, number}) & kExponent) + kTwice;
      factor = reinterpret_cast<Double2>(power)[0];
      inverse = reinterpret_cast<Double2>(kOneTwice - power)[0];
    }

    double factor;
    double inverse;
  };

  // No component of a direction over its scale is more than 1: a gap that is infinite in floats takes so long
  // that a path which ends behind it has no end in floats. An axis that is flat counts as one along which it
  // goes up, infinitely slowly.
  void set_axes(const BoxLanes& box, Float4 direction, float scale) {
    // Not a comparison, which compilers would follow by choices between numbers: these take more operations.
    const Int4 goes_down = reinterpret_cast<Int4>(direction) >> 31;
    const Int4 to_maxima = goes_down & 3 * kFace;
    const auto min = reinterpret_cast<Int4>(canonical(box.min));
    const auto max = reinterpret_cast<Int4>(canonical(box.max));
    const Int4 swap = (min ^ max) & goes_down;
    store4(Int4{0, 1, 2, 2} * kFace + to_maxima, numbers_.near);
    store4(Int4{3, 4, 5, 5} * kFace - to_maxima, numbers_.far);
    store4(reinterpret_cast<Float4>(max ^ swap), numbers_.front);
    store4(reinterpret_cast<Float4>(min ^ swap), numbers_.back);
    const Float4 sooner = -kSmaller * scale / direction;
    store4(sooner, numbers_.sooner);
    store4(sooner * (kLarger * kLarger), numbers_.later);
  }

  void set_flat(const Path& path, Int4 flat) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double direction = path.direction[axis];
      if (direction != 0 && (flat[axis] != 0 || !Cast::has_inverse(direction))) set_flat_axis(path, axis);
    }
  }

  // Boxes that do not reach where the path is are behind its end, and those that it has not left it never
  // leaves. Such a side is 0 times infinity from one that it grazes, which is no bound.
  [[gnu::cold]] void set_flat_axis(const Path& path, unsigned axis) {
    const double way = path.direction[axis] * path.end;
    const float low = canonical(path.box.min[axis]);
    const float high = canonical(path.box.max[axis]);
    const auto minima = static_cast<std::int32_t>(axis) * kFace;
    numbers_.near[axis] = minima;
    numbers_.far[axis] = minima + 3 * kFace;
    numbers_.sooner[axis] = numbers_.later[axis] = -kInfinity;
    numbers_.can_be_certain = false;
    numbers_.back[axis] = way == 0 ? low : below(reach(low, way < 0 ? way : -0.0));
    numbers_.front[axis] = way == 0 ? high : above(reach(high, way > 0 ? way : 0.0));
  }

  // How far it comes from there, and a little further: a small sum of large numbers is as uncertain as they
  // are.
  static double reach(double from, double way) {
    const double slack = 0x1p-48 * (std::fabs(from) + std::fabs(way));
    return from + way + std::copysign(slack, way);
  }

  // Times in lengths of the scaled direction are so many times as large, or hardly less.
  double scale_ = kUsualScale;
  double scale_above_ = kUsualScale * kAbove;
  CastNumbers numbers_;  // NOLINT(*-member-init): all that is read is set by the constructor
};

}  // namespace cellsweep::queries
