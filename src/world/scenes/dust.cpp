#include <algorithm>

#include "world/arithmetic.h"
#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

constexpr BodyId kOneGiantIn = 100;
constexpr BodyId kGiant = 7;
constexpr double kSmallestGrain = 0.001;
constexpr double kDecadesOfEach = 1000;  // from the smallest dust to the smallest giant, and to the largest

// A giant fills 4.8e7 in the mean, so that a body lies in about one of them, or touches it. The largest
// always has room.
double dust_edge(double bodies) {
  constexpr double kRoomForTheLargest = 1500;
  return std::max(78 * cube_root(std::max(bodies, 1.0)), kRoomForTheLargest);
}

Placement place_grain(const Spot& spot, Random& random) {
  const double smallest = spot.id % kOneGiantIn == kGiant ? kSmallestGrain * kDecadesOfEach : kSmallestGrain;
  const auto edge = static_cast<float>(smallest * power(kDecadesOfEach, random.unit()));
  return put({edge, edge, edge}, spot.world_edge, spot.world_edge, random);
}

}  // namespace

SceneRecipe dust_recipe() {
  return {{"dust", "cubes of edges 0.001 to 1, and 1 % giants of edges 1 to 1,000 in which they lie"},
          11,
          dust_edge,
          place_grain};
}

}  // namespace cellsweep
