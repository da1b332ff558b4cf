#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

Placement place_bullet(const Spot& spot, Random& random) {
  constexpr std::array<float, 3> kBullet = {0.1F, 0.1F, 0.1F};
  return put(spot.moves ? kBullet : kUnitCube, spot.world_edge, spot.world_edge, random);
}

}  // namespace

SceneRecipe bullets_recipe() {
  return {{"bullets", "cubes that stand still, and 10 % bullets that fly 2 to 8 of their edges a frame"},
          8,
          uniform_edge,
          place_bullet,
          {.slowest_share = 0.25, .fastest = 8}};
}

}  // namespace cellsweep
