#include <cmath>
#include <string>

#include "base/tuning.h"
#include "bench/tuning/rows.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

constexpr int kTimes = 8;
constexpr std::size_t kBodies = 10'000;

/// Scene `uniform`, of which one cube in 200 becomes a wall: so many times as long on two axes.
std::vector<Aabb> world_with_walls(float edges) {
  const auto source = uniform(kBodies, 0);
  std::vector<Aabb> boxes(source->boxes().begin(), source->boxes().end());
  Random random(1);
  for (std::size_t i = 0; i < kBodies / 200; ++i) {
    const std::size_t thin = i % 3;
    const std::size_t place = random.below(kBodies);
    const Aabb& cube = source->boxes()[place];
    Aabb& wall = boxes[place];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis != thin) wall.max[axis] = cube.min[axis] + edges * (cube.max[axis] - cube.min[axis]);
    }
  }
  return boxes;
}

/// Nanoseconds of a body to find all pairs by cells.
Measured build_cost(float edges) {
  const std::vector<Aabb> boxes = world_with_walls(edges);
  Cells cells;
  const double seconds = quickest_seconds_of(kTimes, [&] { cells.build_seconds(boxes); });
  return {{"cells", 1e9 * seconds / kBodies}};
}

}  // namespace

void register_grid_rows() {
  for (const float by : {0.5F, 0.9F, 1.1F, 2.0F}) {
    const float edges = std::round(by * tuning::kLargeEdges);
    register_tuning_row("kLargeEdges/" + std::to_string(std::lround(edges)),
                        [edges] { return build_cost(edges); });
  }
}

}  // namespace cellsweep::bench
