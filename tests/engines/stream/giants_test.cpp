/// @file
/// One body many times as large as the others, in any slot: it must not cost more than the bodies that it
/// touches.
#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// What stands out in a world.
struct Giant {
  const char* name;
  float half_length[3];  ///< in edges of the world
};

void PrintTo(const Giant& giant, std::ostream* out) {
  *out << giant.name;
}

struct GiantWork {
  std::uint64_t copies;
  std::uint64_t tests;
  std::uint64_t candidates;
};

GiantWork work_on(const std::vector<Aabb>& boxes) {
  Broadphase engine = engine_with(boxes, {.threads = 1});
  EXPECT_TRUE(engine.update().ok());
  EXPECT_TRUE(boxes.size() > 10'000 / kScale || is_exact(engine, boxes));
  return {counter(engine, "boxes in cells"), counter(engine, "boxes compared"),
          counter(engine, "candidates")};
}

class GiantTest : public testing::TestWithParam<std::tuple<Giant, std::size_t>> {};

TEST_P(GiantTest, CostsNoMoreThanTheBodiesItTouchesWhicheverItsSlot) {
  const auto& [giant, count] = GetParam();
  std::vector<Aabb> boxes = uniform_boxes(count / kScale, 9);
  const float world = 2 * std::cbrt(static_cast<float>(boxes.size()));
  const GiantWork without = work_on(boxes);
  for (const std::size_t slot : {std::size_t{0}, boxes.size() / 2, boxes.size() - 1}) {
    std::vector<Aabb> with = boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      with[slot].min[axis] = world / 2 - giant.half_length[axis] * world;
      with[slot].max[axis] = world / 2 + giant.half_length[axis] * world;
    }
    const GiantWork work = work_on(with);
    EXPECT_LE(work.copies, 3 * without.copies) << "slot " << slot;
    EXPECT_LE(work.tests, 3 * without.tests) << "slot " << slot;
    EXPECT_LE(work.candidates, without.candidates + boxes.size());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, GiantTest,
    testing::Combine(testing::Values(Giant{"cube_as_large_as_the_world", {0.5F, 0.5F, 0.5F}},
                                     Giant{"cube_ten_times_the_world", {5, 5, 5}},
                                     Giant{"plane", {5, 0.001F, 5}},
                                     Giant{"plane_of_the_largest_numbers", {1e30F, 0.001F, 1e30F}},
                                     Giant{"rod", {0.001F, 5, 0.001F}}),
                     testing::Values(1000U, 10'000U, 50'000U)),
    [](const auto& test) {
      return std::get<0>(test.param).name + std::string("_among_") + std::to_string(std::get<1>(test.param));
    });

}  // namespace
}  // namespace cellsweep::stream
