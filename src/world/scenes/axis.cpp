#include <algorithm>

#include "world/scenes/placing.h"
#include "world/scenes/recipes.h"

namespace cellsweep {
namespace {

// Two cubes on a line overlap when their centres lie in a stretch of length 2: each overlaps about one other.
double axis_edge(double bodies) {
  constexpr double kSmallest = 12;
  return std::max(2 * bodies, kSmallest);
}

Placement place_on_axis(const Spot& spot, Random& random) {
  constexpr float kLine = 1;  // where it is on the other axes
  Placement placement = place_cube(spot, random);
  placement.centre[1] = kLine;
  placement.centre[2] = kLine;
  return placement;
}

}  // namespace

SceneRecipe axis_recipe() {
  return {{"axis", "unit cubes strung along one axis, on the other two all in the same place"},
          12,
          axis_edge,
          place_on_axis,
          {.axes = {true, false, false}}};
}

}  // namespace cellsweep
