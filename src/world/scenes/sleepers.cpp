#include <algorithm>

#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

std::size_t one_mover(std::size_t bodies) {
  return std::min<std::size_t>(bodies, 1);
}

}  // namespace

SceneRecipe sleepers_recipe() {
  return {{"sleepers", "unit cubes spread evenly, all of them asleep but one", std::nullopt},
          10,
          uniform_edge,
          place_cube,
          {},
          one_mover};
}

}  // namespace cellsweep
