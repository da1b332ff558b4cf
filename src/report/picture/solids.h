/// @file
/// Solid boxes in any position, and what a ray meets first among them.
#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "cellsweep/pose.h"

namespace cellsweep::report {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;  ///< of length 1
};

/// Where a ray meets a solid.
struct Hit {
  std::uint32_t solid = 0;
  float distance = 0;
  Eigen::Vector3f normal;   ///< of length 1, outwards
  float edge_distance = 0;  ///< from the point to the nearest edge of the face, in world units
};

/// A box that can be hit.
struct Solid {
  Eigen::Vector3f centre;
  Eigen::Vector3f half_extents;
  Eigen::Matrix3f axes;  ///< its own axes as columns, of length 1
};

Solid solid_of(const BodyPose& pose);

/// A tree over solids, by Embree. What is hit is decided by arithmetic of our own; Embree only finds the
/// candidates. Any number of threads may ask at once.
class Solids {
 public:
  /// Throws std::bad_alloc.
  explicit Solids(std::vector<Solid> solids);
  ~Solids();
  Solids(const Solids&) = delete;
  Solids& operator=(const Solids&) = delete;

  std::size_t size() const { return solids_.size(); }

  /// True when the ray meets a solid; then `hit` is the nearest one's, and of several at one distance that
  /// of the smallest number.
  bool first_hit(const Ray& ray, Hit& hit) const;

  /// True when anything is in the way.
  bool is_blocked(const Ray& ray) const;

 private:
  void release();  // what Embree gave

  static void tell_bounds(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);
  static void occlude(const RTCOccludedFunctionNArguments* arguments);

  std::vector<Solid> solids_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace cellsweep::report
