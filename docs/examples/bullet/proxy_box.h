/// @file
/// What cellsweep calls a box of Bullet and the filter of a proxy.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <cellsweep/aabb.h>
#include <cellsweep/filter.h>

#include <type_traits>

/// Rounded to the outside, for where btScalar is double.
cellsweep::Aabb box_around(const btVector3& low, const btVector3& high);

inline cellsweep::Aabb box_of(const btVector3& low, const btVector3& high) {
  if constexpr (std::is_same_v<btScalar, float>) {
    return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
  } else {
    return box_around(low, high);
  }
}
inline cellsweep::Aabb box_of(const btBroadphaseProxy& proxy) {
  return box_of(proxy.m_aabbMin, proxy.m_aabbMax);
}

/// What is in the group of static bodies alone and does not meet it is static.
cellsweep::BodyFilter filter_of(const btBroadphaseProxy& proxy);
