/// @file
/// Walks through the bodies around a box, the nearer ones before others mostly.
#pragma once

#include "queries/nearest/nearest_list.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Offers a list all bodies that may be among the nearest, each once.
void walk_nearest(const World& world, const Aabb& box, const QueryFilter& filter, NearestList& nearest);

}  // namespace cellsweep::queries
