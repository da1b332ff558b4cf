/// @file
/// What cellsweep calls a ray of Bullet.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <cellsweep/query.h>

#include <optional>

/// The path of a box that is cast along a ray, or of the ray itself where the box is (0, 0, 0) alone. It has
/// a little more room, so that it touches all that the ray meets when btRayAabb2() rounds, and a few boxes
/// besides: half a millionth of the ray's length on each axis.
///
/// Nothing for a ray that goes more than ten million units on more than one axis: there would be room for a
/// whole world. Queries refuse the path of a ray with NaN or infinity, or with an end below 0.
std::optional<cellsweep::Path> path_of(const btVector3& from, const btBroadphaseRayCallback& ray,
                                       const btVector3& aabb_min, const btVector3& aabb_max);
