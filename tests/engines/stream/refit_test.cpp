/// @file
/// Heaps that come to rest: what fat boxes had to hold while all moved about is not looked at for ever.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// Cubes side by side, with little room between them.
std::vector<Aabb> heap(std::size_t edge) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < edge * edge * edge; ++i) {
    const std::size_t place[3] = {i % edge, i / edge % edge, i / edge / edge};
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = 1.1F * static_cast<float>(place[axis]);
      box.max[axis] = box.min[axis] + 1;
    }
    boxes.push_back(box);
  }
  return boxes;
}

TEST(Refit, LeavesFewCandidatesOnceAHeapIsAtRest) {
  const std::vector<Aabb> places = heap(16);  // more than are swept
  Broadphase engine = engine_with(places);
  const auto tremble = [&](float most, std::uint64_t frame) {
    std::vector<Aabb> boxes = places;
    shake(boxes, most, frame);
    move_every(engine, boxes, 1);
    ASSERT_TRUE(engine.update().ok());
    if (frame % 16 == 0) {
      ASSERT_TRUE(is_exact(engine, boxes));
    }
  };
  for (std::uint64_t frame = 0; frame < 40; ++frame) ASSERT_NO_FATAL_FAILURE(tremble(0.05F, frame));
  const std::uint64_t moving = counter(engine, "candidates");
  EXPECT_GT(moving, 4 * places.size());
  for (std::uint64_t frame = 0; frame < 150; ++frame) ASSERT_NO_FATAL_FAILURE(tremble(1e-4F, frame));
  EXPECT_LT(counter(engine, "candidates"), moving / 4);
  const std::uint64_t full = counter(engine, "full updates");
  for (std::uint64_t frame = 0; frame < 150; ++frame) ASSERT_NO_FATAL_FAILURE(tremble(1e-4F, frame));
  EXPECT_EQ(counter(engine, "full updates"), full) << "once is enough";
}

}  // namespace
}  // namespace cellsweep::stream
