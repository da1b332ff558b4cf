#include "ray_path.h"

#include <limits>

#include "proxy_box.h"

namespace {

bool is_long(const btVector3& way) {
  constexpr btScalar kLong = 1e7;
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) axes += way[axis] > kLong ? 1 : 0;
  return axes > 1;
}

// btRayAabb2() has for the way to a face of a box a difference of two sums, each rounded, times a number that
// is rounded: off by one epsilon of the numbers and two of the way. The box that is cast is rounded here,
// too. Cellsweep takes for 0 what is less than any normal float.
btVector3 room_for_rounding(const btVector3& numbers, const btVector3& way) {
  constexpr btScalar kTiny = 4 * std::numeric_limits<float>::min();
  return (numbers + way) * (4 * SIMD_EPSILON) + btVector3(kTiny, kTiny, kTiny);
}

}  // namespace

// Where a direction is 0 Bullet has a large number for its inverse, and goes on by next to nothing. So does
// the path. Signs that are not those of the direction only make btRayAabb2() miss boxes.
std::optional<cellsweep::Path> path_of(const btVector3& from, const btBroadphaseRayCallback& ray,
                                       const btVector3& aabb_min, const btVector3& aabb_max) {
  const btVector3& inverse = ray.m_rayDirectionInverse;
  const btVector3 end(ray.m_lambda_max, ray.m_lambda_max, ray.m_lambda_max);
  const btVector3 way = (end / inverse).absolute();
  if (is_long(way)) return std::nullopt;
  const btVector3 room = room_for_rounding(from.absolute() + aabb_min.absolute() + aabb_max.absolute(), way);
  cellsweep::MovingBox moving;
  moving.box = box_of(from + aabb_min - room, from + aabb_max + room);
  moving.direction = {1 / double{inverse.x()}, 1 / double{inverse.y()}, 1 / double{inverse.z()}};
  moving.end = ray.m_lambda_max;
  return moving;
}
