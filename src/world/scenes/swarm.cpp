#include <algorithm>

#include "world/arithmetic.h"
#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

constexpr float kParticle = 0.1F;

// With the density of place_particle() each particle overlaps about two others.
double swarm_edge(double bodies) {
  constexpr double kSmallest = 12;  // particles
  return static_cast<double>(kParticle) * std::max(2.6 * cube_root(std::max(bodies, 1.0)), kSmallest);
}

// The mean of three random places: a cloud that thins out towards the walls.
Placement place_particle(const Spot& spot, Random& random) {
  Placement placement{{kParticle, kParticle, kParticle}, {}};
  for (int draw = 0; draw < 3; ++draw) {
    const Placement one = put(placement.edges, spot.world_edge, spot.world_edge, random);
    for (std::size_t axis = 0; axis < 3; ++axis) placement.centre[axis] += one.centre[axis] / 3;
  }
  return placement;
}

}  // namespace

SceneRecipe swarm_recipe() {
  return {{"swarm", "particles of one size, a cloud of them that is thickest in its middle; all move", 1.0},
          9,
          swarm_edge,
          place_particle};
}

}  // namespace cellsweep
