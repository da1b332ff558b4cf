/// @file
/// How each seeded scene is laid out: the size of its world, and the size and place of each body.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cellsweep/world/scene.h"
#include "world/random.h"

namespace cellsweep {

/// A body at rest in world units, not turned.
struct Placement {
  std::array<float, 3> edges{};
  std::array<float, 3> centre{};
};

/// One scene. Its world is the cube from the origin to (edge, edge, edge); y is up.
struct SceneRecipe {
  SceneInfo info;
  std::uint64_t stream = 0;  ///< keeps the random numbers of two scenes with one seed apart; never changes
  double (*world_edge)(double bodies) = nullptr;
  /// Inside the world also after rounding. Draws from `random` whatever it needs.
  Placement (*place)(BodyId id, float world_edge, Random& random) = nullptr;
};

/// All scenes, in the order of scene_table().
std::span<const SceneRecipe> scene_recipes();

}  // namespace cellsweep
