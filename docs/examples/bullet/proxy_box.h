/// @file
/// What cellsweep calls the box and the filter of a proxy of Bullet.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <cellsweep/aabb.h>
#include <cellsweep/filter.h>

/// Where btScalar is double, rounded to the outside.
cellsweep::Aabb box_of(const btBroadphaseProxy& proxy);

/// What is in the group of static bodies alone and does not meet it is static.
cellsweep::BodyFilter filter_of(const btBroadphaseProxy& proxy);
