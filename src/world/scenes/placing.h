/// @file
/// What several recipes of scenes share.
#pragma once

#include "world/scene_recipes.h"

namespace cellsweep {

inline constexpr std::array<float, 3> kUnitCube = {1, 1, 1};

/// A random place for a body between the floor and `height`. The margin of two float steps keeps box and
/// world apart when the centre and the box are rounded.
Placement put(const std::array<float, 3>& edges, float world_edge, float height, Random& random);

/// A unit cube anywhere in the world, and the edge of a world in which each overlaps about one other.
Placement place_cube(const Spot& spot, Random& random);
double uniform_edge(double bodies);

}  // namespace cellsweep
