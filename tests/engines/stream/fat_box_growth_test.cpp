/// @file
/// How far fat boxes reach: further where that brings no candidates, less far where it brings too many.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// Columns of unit cubes, each a little into the one below it, so far from column to column.
std::vector<Aabb> columns(float apart) {
  constexpr std::size_t kEdge = 24;
  constexpr std::size_t kHigh = 10;
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < kEdge * kEdge * kHigh; ++i) {
    const std::size_t column = i / kHigh;
    const Aabb box = {{apart * static_cast<float>(column % kEdge), 0.99F * static_cast<float>(i % kHigh),
                       apart * static_cast<float>(column / kEdge)},
                      {}};
    boxes.push_back({box.min, {box.min[0] + 1, box.min[1] + 1, box.min[2] + 1}});
  }
  return boxes;
}

/// How many fat boxes were put into cells while columns that stand so far apart crept along y for long.
std::uint64_t placed_while_creeping(float apart) {
  std::vector<Aabb> boxes = columns(apart);
  Broadphase engine = engine_with(boxes);
  EXPECT_TRUE(engine.update().ok());
  for (int update = 0; update < 400; ++update) {
    for (Aabb& box : boxes) {
      box.min[1] += 1e-4F;
      box.max[1] += 1e-4F;
    }
    move_every(engine, boxes, 1);
    EXPECT_TRUE(engine.update().ok());
    if (update % 100 == 0) {
      EXPECT_TRUE(is_exact(engine, boxes));
    }
  }
  return counter(engine, "fat boxes put into cells");
}

// Bodies that rest on each other and on nothing else: each pair of fat boxes is one of boxes, however far
// they reach along the columns.
TEST(FatBoxesOfCreeping, LastForLongWhereTheyBringNoCandidates) {
  EXPECT_LE(placed_while_creeping(1.5F), 3 * columns(1.5F).size());
}

struct Trembling {
  double candidates = 0;  // for each pair, in the mean of the second half
  double placed = 0;      // fat boxes in an update for each body
};

/// What columns that stand so far apart cost while they tremble by as much as `step`.
Trembling cost_of_trembling(float apart, float step) {
  constexpr std::uint64_t kUpdates = 300;
  const std::vector<Aabb> places = columns(apart);
  Broadphase engine = engine_with(places);
  EXPECT_TRUE(engine.update().ok());
  std::uint64_t candidates = 0;
  std::uint64_t pairs = 0;
  for (std::uint64_t update = 0; update < kUpdates; ++update) {
    std::vector<Aabb> boxes = places;
    shake(boxes, step, update);
    move_every(engine, boxes, 1);
    EXPECT_TRUE(engine.update().ok());
    if (update % 100 == 99) {
      EXPECT_TRUE(is_exact(engine, boxes));
    }
    if (update < kUpdates / 2) continue;
    candidates += counter(engine, "candidates");
    pairs += engine.pairs().size();
  }
  const auto bodies = static_cast<double>(places.size());
  return {static_cast<double>(candidates) / static_cast<double>(pairs),
          static_cast<double>(counter(engine, "fat boxes put into cells")) / bodies / kUpdates};
}

// Room between them is less than what fat boxes would take that are not made for how much they tremble.
TEST(FatBoxesOfTrembling, HaveFewCandidatesHoweverCloseTheyStand) {
  for (const float apart : {1.01F, 1.03F, 1.08F, 1.5F}) {
    const Trembling cost = cost_of_trembling(apart, 1e-3F);
    EXPECT_LE(cost.candidates, 1.5) << apart;
    EXPECT_LE(cost.placed, 0.05) << apart;
  }
}

TEST(FatBoxesOfTrembling, HaveFewCandidatesHoweverLittleTheyTremble) {
  for (const float step : {1e-5F, 1e-4F, 1e-3F}) {
    const Trembling cost = cost_of_trembling(1.02F, step);
    EXPECT_LE(cost.candidates, 1.5) << step;
    EXPECT_LE(cost.placed, 0.05) << step;
  }
}

}  // namespace
}  // namespace cellsweep::stream
