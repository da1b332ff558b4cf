#include <algorithm>
#include <cmath>

#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

constexpr float kTile = 2;
constexpr float kFloor = 0.5F;  // how high a tile of the floor is
constexpr float kWall = 4;

double tiles_on_a_side(double bodies) {
  return std::max(1.0, std::ceil(std::sqrt(bodies)));
}

double level_edge(double bodies) {
  return std::max(static_cast<double>(kTile) * tiles_on_a_side(bodies), 2.0 * static_cast<double>(kWall));
}

// Rows along x. Where a body moves its tile is missing, as a door or a pit is.
Placement place_tile(const Spot& spot, Random& random) {
  constexpr double kWalls = 0.125;
  const auto side = static_cast<BodyId>(spot.world_edge / kTile);
  const float height = random.unit() < kWalls ? kWall : kFloor;
  const auto middle = [](BodyId cell) { return kTile * (static_cast<float>(cell) + 0.5F); };
  return {{kTile, height, kTile}, {middle(spot.id % side), 0.5F * height, middle(spot.id / side)}};
}

Placement place_character(const Spot& spot, Random& random) {
  constexpr std::array<float, 3> kCharacter = {0.6F, 1.8F, 0.6F};
  Placement placement = put(kCharacter, spot.world_edge, spot.world_edge, random);
  placement.centre[1] = kFloor + 0.5F * kCharacter[1];
  return placement;
}

Placement place_in_level(const Spot& spot, Random& random) {
  return spot.moves ? place_character(spot, random) : place_tile(spot, random);
}

}  // namespace

SceneRecipe level_recipe() {
  return {
      {"level", "tiles of floors and walls that touch and stay, and 5 % characters that walk on them", 0.05},
      7,
      level_edge,
      place_in_level,
      {.axes = {true, false, true}}};
}

}  // namespace cellsweep
