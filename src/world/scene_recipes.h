/// @file
/// How each scene that is a World is laid out: the size of its world, the size and place of each body, and
/// how those that move set off.
#pragma once

#include <array>
#include <cstddef>
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

/// Whose place is wanted.
struct Spot {
  BodyId id = 0;
  float world_edge = 0;
  bool moves = false;
};

/// How the bodies that move set off. Speeds in shortest edges a frame.
struct Gait {
  double slowest_share = 0;  ///< of the fastest
  double fastest = 0.1;
  std::array<bool, 3> axes = {true, true, true};  ///< those on which a body moves at all
};

/// One scene. Its world is the cube from the origin to (edge, edge, edge); y is up.
struct SceneRecipe {
  SceneInfo info;
  std::uint64_t stream = 0;  ///< keeps the random numbers of two scenes with one seed apart; never changes
  double (*world_edge)(double bodies) = nullptr;
  /// Inside the world also after rounding. Draws from `random` whatever it needs.
  Placement (*place)(const Spot& spot, Random& random) = nullptr;
  Gait gait{};
  /// How many move where SceneInfo has no share; null where it has.
  std::size_t (*movers)(std::size_t bodies) = nullptr;
};

/// All of them, in the order of scene_table().
std::span<const SceneRecipe> scene_recipes();

/// The recipe of a scene, or null when it has none.
const SceneRecipe* find_recipe(std::string_view name);

}  // namespace cellsweep
