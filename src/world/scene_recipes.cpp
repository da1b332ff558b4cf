#include "world/scene_recipes.h"

#include <algorithm>
#include <cmath>

#include "world/arithmetic.h"
#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

constexpr double kSmallestWorld = 12;

}  // namespace

Placement put(const std::array<float, 3>& edges, float world_edge, float height, Random& random) {
  const double margin = 0x1p-22 * static_cast<double>(world_edge);
  Placement placement{edges, {}};
  for (int axis = 0; axis < 3; ++axis) {
    const double room = axis == 1 ? height : world_edge;
    const double keep_off = 0.5 * static_cast<double>(edges[axis]) + margin;
    placement.centre[axis] = static_cast<float>(random.between(keep_off, room - keep_off));
  }
  return placement;
}

// Two cubes overlap when their centres lie in a cube of edge 2: one such volume a body, so that each
// overlaps about one other.
double uniform_edge(double bodies) {
  return std::max(2 * cube_root(std::max(bodies, 1.0)), kSmallestWorld);
}

Placement place_cube(const Spot& spot, Random& random) {
  return put(kUnitCube, spot.world_edge, spot.world_edge, random);
}

namespace {

/// As uniform: 284.8 is the mean of (e + f)^3 over two log-uniform edges e and f.
double varied_edge(double bodies) {
  constexpr double kRoomForTheLargest = 40;
  return std::max(cube_root(std::max(284.8 * bodies, 1.0)), kRoomForTheLargest);
}

Placement place_varied(const Spot& spot, Random& random) {
  const auto edge = static_cast<float>(0.1 * power(100, random.unit()));
  return put({edge, edge, edge}, spot.world_edge, spot.world_edge, random);
}

double clustered_edge(double bodies) {
  return std::max(std::sqrt(0.72 * bodies), kSmallestWorld);
}

Placement place_clustered(const Spot& spot, Random& random) {
  constexpr float kLayerHeight = 5;
  const float height = random.unit() < 0.9 ? kLayerHeight : spot.world_edge;
  return put(kUnitCube, spot.world_edge, height, random);
}

Placement place_wall(const Spot& spot, Random& random) {
  constexpr BodyId kOneSheetIn = 100;
  constexpr BodyId kSheet = 17;
  if (spot.id % kOneSheetIn != kSheet) return place_cube(spot, random);
  const int thin = static_cast<int>(random.below(3));
  std::array<float, 3> edges = kUnitCube;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != thin)
      edges[axis] = static_cast<float>(random.between(0.1, 0.5) * static_cast<double>(spot.world_edge));
  }
  return put(edges, spot.world_edge, spot.world_edge, random);
}

/// The shortest side of a cubic lattice with room for all.
double touch_edge(double bodies) {
  double side = 1;
  while (side * side * side < bodies) side += 1;
  return side;
}

/// Rows along x fill layers, layers go up; every coordinate of a box is a whole number.
Placement place_touch(const Spot& spot, Random&) {
  const auto side = static_cast<BodyId>(spot.world_edge);
  const BodyId column = spot.id % side;
  const BodyId row = spot.id / side % side;
  const BodyId layer = spot.id / side / side;
  const auto middle = [](BodyId cell) { return static_cast<float>(cell) + 0.5F; };
  return {kUnitCube, {middle(column), middle(layer), middle(row)}};
}

/// The same bounds whatever the count (3.2.3, E1).
double paper_edge(double) {
  return 20;
}

}  // namespace

std::span<const SceneRecipe> scene_recipes() {
  static const std::array recipes = {
      SceneRecipe{
          {"uniform", "unit cubes spread evenly, about one overlap for each"}, 1, uniform_edge, place_cube},
      SceneRecipe{{"varied", "cubes of edges 0.1 to 10, as many of each order of size"},
                  2,
                  varied_edge,
                  place_varied},
      SceneRecipe{{"clustered", "unit cubes, 90 % of them in a layer of height 5 on the floor"},
                  3,
                  clustered_edge,
                  place_clustered},
      SceneRecipe{{"wall", "unit cubes and 1 % thin sheets that cover 10 to 50 % of the world on two axes"},
                  4,
                  uniform_edge,
                  place_wall},
      SceneRecipe{{"touch", "a lattice of unit cubes that touch at faces, edges and corners"},
                  5,
                  touch_edge,
                  place_touch},
      SceneRecipe{{"paper", "unit cubes in the same world of edge 20 whatever their number (chapter 3.2.3)"},
                  6,
                  paper_edge,
                  place_cube},
      level_recipe(),
      bullets_recipe(),
      swarm_recipe(),
      sleepers_recipe(),
      dust_recipe(),
      axis_recipe(),
  };
  return recipes;
}

const SceneRecipe* find_recipe(std::string_view name) {
  const auto recipes = scene_recipes();
  const auto found = std::find_if(recipes.begin(), recipes.end(),
                                  [&](const SceneRecipe& recipe) { return recipe.info.name == name; });
  return found == recipes.end() ? nullptr : &*found;
}

}  // namespace cellsweep
