/// @file
/// Numbers that are spread evenly over a square, and directions made of them; the same on every machine.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "cellsweep/pair.h"

namespace cellsweep::report {

struct Point2 {
  float x = 0;
  float y = 0;
};

/// The points that the rays of one pixel use: an additive sequence, shifted for each pixel and purpose so
/// that neighbours do not show the same pattern.
class Samples {
 public:
  explicit Samples(std::uint64_t pixel) : pixel_(pixel) {}

  /// In the unit square. `purpose` tells apart the points that one ray needs.
  Point2 point(unsigned index, unsigned purpose) const {
    const std::uint64_t shift = mix64(pixel_ * 4 + purpose + 1);
    return {wrap(static_cast<std::uint32_t>(shift), index, kStepX),
            wrap(static_cast<std::uint32_t>(shift >> 32), index, kStepY)};
  }

 private:
  // Fractions of 2^32, which wrap around by themselves: 1/p and 1/p² for p³ = p + 1.
  static constexpr std::uint32_t kStepX = 3242174889;
  static constexpr std::uint32_t kStepY = 2447445414;

  static float wrap(std::uint32_t shift, unsigned index, std::uint32_t step) {
    return static_cast<float>((shift + index * step) >> 8) * 0x1p-24F;
  }

  std::uint64_t pixel_;
};

/// A point of the unit square laid onto the unit disk.
inline Point2 on_disk(Point2 square) {
  const float x = 2 * square.x - 1;
  const float y = 2 * square.y - 1;
  return {x * std::sqrt(1 - 0.5F * y * y), y * std::sqrt(1 - 0.5F * x * x)};
}

/// A direction close to `axis` (of length 1): the disk stands across its tip.
inline Eigen::Vector3f around(const Eigen::Vector3f& axis, Point2 disk, float along) {
  const Eigen::Vector3f helper =
      std::fabs(axis.x()) < 0.6F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY();
  const Eigen::Vector3f side = axis.cross(helper).normalized();
  return (axis * along + side * disk.x + axis.cross(side) * disk.y).normalized();
}

/// More often along the normal than across it, as light that comes from everywhere counts.
inline Eigen::Vector3f above_surface(const Eigen::Vector3f& normal, Point2 square) {
  const Point2 disk = on_disk(square);
  const float rest = 1 - disk.x * disk.x - disk.y * disk.y;
  return around(normal, disk, std::sqrt(rest > 0 ? rest : 0.0F));
}

}  // namespace cellsweep::report
