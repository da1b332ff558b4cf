/// @file
/// Grids: which cells a box reaches into, which of them owns a pair, and how fine a grid is chosen.
#include "engines/stream/cells/grid.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <set>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// Coordinates of every size, with those next to each other in floating point among them.
std::vector<float> many_coordinates() {
  std::vector<float> values = {0, -FLT_MAX, FLT_MAX, FLT_MIN, -FLT_MIN};
  for (int exponent = -126; exponent < 128; exponent += 2) {
    for (const float sign : {-1.0F, 1.0F}) {
      const float value = std::ldexp(1.3F * sign, exponent);
      values.insert(values.end(), {std::nextafter(value, 0.0F), value, value * 1.0000002F});
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

Aabb point(float x, float y, float z) {
  return {{x, y, z}, {x, y, z}};
}

TEST(Grid, CellsNeverDecreaseWithTheCoordinateWhateverItsScale) {
  const std::vector<float> values = many_coordinates();
  for (const double scale : {1e-38, 1e-20, 0.37, 1.0, 123.0, 1e20, 3e38}) {
    for (const double origin : {-1e38, -7.0, 0.0, 3.0, 1e30}) {
      const Grid grid({origin, 0, 0}, {scale, 0, 0}, {1000, 1, 1});
      std::uint32_t last = 0;
      for (const float value : values) {
        const std::uint32_t cell = grid.block_of(point(value, 0, 0)).first;
        ASSERT_GE(cell, last);
        ASSERT_LT(cell, 1000U);
        last = cell;
      }
    }
  }
}

TEST(Grid, ABoxReachesIntoTheCellsOfAllItsPoints) {
  contract::Random random(1);
  const Grid grid({0, 0, 0}, {0.5, 0.3, 0.7}, {5, 4, 6});
  for (int round = 0; round < 2000; ++round) {
    const Aabb box = cube_in(random, random.between(0, 5), 10);
    std::set<std::uint32_t> cells;
    grid.for_each_cell(grid.block_of(box), [&](std::uint32_t cell, std::uint32_t) { cells.insert(cell); });
    EXPECT_EQ(cells.size(), grid.block_of(box).cells());
    EXPECT_LT(*cells.rbegin(), grid.cells());
    for (int i = 0; i < 20; ++i) {
      const auto within = [&](std::size_t axis) {
        return std::clamp(random.between(box.min[axis], box.max[axis]), box.min[axis], box.max[axis]);
      };
      const Aabb inside = point(within(0), within(1), within(2));
      ASSERT_TRUE(cells.contains(grid.block_of(inside).first));
    }
  }
}

TEST(Grid, ExactlyOneOfTheCellsThatTwoBoxesShareOwnsTheirPair) {
  contract::Random random(2);
  const Grid grid({0, 0, 0}, {0.5, 0.3, 0.7}, {5, 4, 6});
  for (int round = 0; round < 3000; ++round) {
    const Aabb one = cube_in(random, random.between(0, 4), 8);
    const Aabb other = cube_in(random, random.between(0, 4), 8);
    int owners = 0;
    grid.for_each_cell(grid.block_of(one), [&](std::uint32_t cell, std::uint32_t flags) {
      grid.for_each_cell(grid.block_of(other), [&](std::uint32_t other_cell, std::uint32_t other_flags) {
        owners += cell == other_cell && (flags | other_flags) == kWholeFlags ? 1 : 0;
      });
    });
    ASSERT_TRUE(owners == 1 || !overlap(one, other));
    ASSERT_LE(owners, 1);
  }
}

TEST(GridChoice, CutsAWorldThatIsSpreadOutAndLeavesOneThatIsNot) {
  const std::vector<Aabb> spread = uniform_boxes(5000, 3);
  const GridChoice cut = choose_grid({spread.data(), spread.size()}, Look::at_all);
  EXPECT_TRUE(cut.pays);
  EXPECT_GT(cut.grid.cells(), 50U);
  const std::vector<Aabb> heap(5000, Aabb{{1, 1, 1}, {2, 2, 2}});
  EXPECT_FALSE(choose_grid({heap.data(), heap.size()}, Look::at_all).pays);
}

TEST(GridChoice, OneBodyFarAwayDoesNotSpoilTheGridOfTheOthers) {
  std::vector<Aabb> boxes = uniform_boxes(5000, 4);
  boxes[17] = point(1e30F, 1e30F, 1e30F);
  const GridChoice choice = choose_grid({boxes.data(), boxes.size()}, Look::at_all);
  std::vector<std::uint32_t> counts(choice.grid.cells(), 0);
  for (const Aabb& box : boxes) ++counts[choice.grid.block_of(box).first];
  EXPECT_LT(*std::max_element(counts.begin(), counts.end()), boxes.size() / 20);
}

}  // namespace
}  // namespace cellsweep::stream
