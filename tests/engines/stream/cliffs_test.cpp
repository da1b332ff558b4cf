/// @file
/// A search for worlds that cost engine `stream` too much: worlds of a few crowds are changed at random, the
/// costlier one is kept, and the costliest must cost no more than a multiple of its bodies and pairs. Work is
/// counted, not timed.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "contract/effort.h"
#include "engines/stream/crowds.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

/// What it takes to find the pairs of these boxes anew, in vectors of sixteen comparisons and boxes put into
/// cells, for each body and four pairs. 0 for a heap, in which everybody overlaps very many.
double work_of(const std::vector<Aabb>& boxes) {
  Broadphase engine = engine_with(boxes, {.threads = 1, .max_pairs = 40 * boxes.size()});
  const auto changes = engine.update();
  if (!changes.ok()) return 0;
  const auto work =
      static_cast<double>(counter(engine, "boxes compared") / 16 + counter(engine, "boxes in cells"));
  return work / (static_cast<double>(boxes.size()) + static_cast<double>(changes->began.size()) / 4);
}

/// In worlds that are cut into cells, and in those that are swept: eight vectors of 64 bytes a body.
struct Case {
  const char* name;
  std::size_t bodies;
  double most;
};

constexpr Case kCases[] = {{"cut", 2600, 20}, {"swept", 1500, 40}};

class Cliffs : public testing::TestWithParam<Case> {};

TEST_P(Cliffs, AreNotFoundBySearchingForThem) {
  for (std::uint64_t seed = 1; seed <= contract::repeated<std::uint64_t>(400, 24 / kScale); ++seed) {
    Random random(seed);
    CrowdedWorld worst = random_world(random);
    double most = work_of(boxes_of(worst, GetParam().bodies));
    for (int i = 0; i < contract::repeated(300, 60); ++i) {
      const CrowdedWorld next = random.one_in(10) ? random_world(random) : mutated(worst, random);
      const double work = work_of(boxes_of(next, GetParam().bodies));
      if (work <= most) continue;
      worst = next;
      most = work;
    }
    EXPECT_LE(most, GetParam().most) << testing::PrintToString(worst);
  }
}

// Compared all with all before what lies outside of the range of most boxes was left out of the choice of a
// grid, and an axis that is not cut was taken for one that has borders.
TEST_P(Cliffs, AreNotWhereTheyWereFoundOnce) {
  const CrowdedWorld worlds[] = {
      {{{0.076F, {0.001F, 0.011F, 0.16F}, {0.065F, 0.12F, 13}, {-0.17F, -3, -190}, 2.6F},
        {0.016F, {0.2F, 25, 21}, {3, 2700, 1200}, {-0.45F, -22, -0.12F}, 0.7F}}},
      {{{0.012F, {4.1F, 0.3F, 0.01F}, {76, 0.28F, 2.5F}, {19, 49, 0.33F}, 2.5F},
        {0.19F, {0.56F, 0.00025F, 250}, {0.0017F, 0.17F, 0.0086F}, {-350, 0.15F, 2.4F}, 2.9F}}},
      {{{0.0094F, {0.17F, 1.4F, 8.9F}, {0.016F, 690, 0.42F}, {2.8F, -50, -0.56F}, 2.1F},
        {0.73F, {170, 0.1F, 0.085F}, {0.0013F, 1.7F, 4.8F}, {7.8F, 35, 0.13F}, 3}}},
      {{{0.00024F, {0.0036F, 0.067F, 16}, {1.6F, 67, 110}, {0.34F, 2, -0.082F}, 0.6F},
        {0.001F, {0.0041F, 300, 0.075F}, {0.07F, 3800, 12}, {-0.046F, -98, -69}, 2.5F},
        {0.003F, {7.7F, 0.57F, 110}, {0.012F, 62, 0.024F}, {200, -15, -5.2F}, 2.3F}}}};
  for (const CrowdedWorld& world : worlds) {
    const std::vector<Aabb> boxes = boxes_of(world, GetParam().bodies);
    EXPECT_LE(work_of(boxes), GetParam().most) << testing::PrintToString(world);
    Broadphase engine = engine_with(boxes);
    ASSERT_TRUE(engine.update().ok());
    EXPECT_TRUE(is_exact(engine, boxes));
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, Cliffs, testing::ValuesIn(kCases),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace cellsweep::stream
