/// @file
/// A tableau made ready for light: its bodies, the frame of its world, the floor, sun and sky.
#pragma once

#include <Eigen/Geometry>

#include "report/picture/picture.h"
#include "report/picture/samples.h"
#include "report/picture/solids.h"

namespace cellsweep::report {

/// Light as red, green and blue, 1 for white paper in daylight.
using Light = Eigen::Vector3f;

/// Any number of threads may ask at once.
class Stage {
 public:
  explicit Stage(const Tableau& tableau);

  /// The light that comes back along a ray; `index` is the number of the pixel's sample.
  Light seen_by(const Ray& ray, const Samples& samples, unsigned index) const;

 private:
  struct Surface {
    Eigen::Vector3f point;
    Eigen::Vector3f normal;
    Light albedo;
  };

  Light albedo_of(const Hit& hit) const;
  Light floor_albedo(const Eigen::Vector3f& point) const;
  bool meets_floor(const Ray& ray, Eigen::Vector3f& point) const;
  Light lit(const Surface& surface, const Samples& samples, unsigned index) const;

  Aabb world_;
  Eigen::Vector3f centre_;
  float size_;  // longest edge of the world
  std::vector<bool> colliding_;
  std::vector<std::uint32_t> groups_;
  Solids solids_;
};

}  // namespace cellsweep::report
