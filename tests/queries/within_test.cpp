/// @file
/// Who is within a distance is decided to the last bit, with a tree and without: distances are asked for that
/// bodies have, and the numbers next to those.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/options.h"
#include "contract/random.h"
#include "queries/arithmetic.h"
#include "queries/short_sort.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

/// Lengths at which squares in floats lose bits, are nothing, or are more than a float holds, too.
constexpr float kScales[] = {1, 1e-16F, 1e-22F, 1e-36F, 3e18F, 1e20F, FLT_MAX / 32};

/// Some of no extent, and many as far as others from where most questions are asked.
Aabb some_box(Random& random, float scale) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = static_cast<float>(random.whole(-8, 8)) * scale;
    box.max[axis] = box.min[axis] + static_cast<float>(random.whole(0, 2)) * scale;
    if (random.one_in(3)) box.max[axis] += random.unit() * scale;
  }
  return box;
}

struct MeasuredWorld {
  MeasuredWorld(Broadphase&& empty, float scale, Random& random) : broadphase(std::move(empty)) {
    for (BodyId id = 0; id < 600; ++id) {
      ids.push_back(id);
      boxes.push_back(canonical(some_box(random, scale)));
    }
    EXPECT_TRUE(broadphase.insert(ids, boxes).ok());
    EXPECT_TRUE(broadphase.update().status().ok());
  }

  void compare(const Aabb& from, double distance) const {
    std::vector<Neighbor> expected;
    for (const BodyId id : ids) {
      const double there = distance_of(from, boxes[id]);
      if (there <= distance) expected.push_back({id, there});
    }
    std::vector<BodyId> bodies;
    for (const Neighbor& neighbor : expected) bodies.push_back(neighbor.body);
    std::ranges::sort(expected, Nearer());
    const Region region(from, distance);
    std::vector<BodyId> found;
    ASSERT_TRUE(broadphase.queries().find_overlaps(region, found).ok());
    ASSERT_EQ(found, bodies) << distance;
    std::vector<Neighbor> neighbors;
    ASSERT_TRUE(broadphase.queries().find_within(region, neighbors).ok());
    ASSERT_EQ(neighbors, expected) << distance;
    const auto any = broadphase.queries().any_overlap(region);
    ASSERT_TRUE(any.ok());
    ASSERT_EQ(*any, !bodies.empty()) << distance;
  }

  Broadphase broadphase;
  std::vector<BodyId> ids;
  std::vector<Aabb> boxes;
};

class Within : public testing::TestWithParam<VectorIsa> {};

TEST_P(Within, BodiesAreFoundAtTheirOwnDistanceAndNotBelow) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Random random(3);
  for (const float scale : kScales) {
    Result<Broadphase> empty = make_broadphase(StreamOptions{.isa = GetParam()});
    if (!empty) GTEST_SKIP() << empty.status().message;
    const MeasuredWorld world(std::move(*empty), scale, random);
    for (int question = 0; question < 60; ++question) {
      if (question == 30) world.broadphase.queries().prepare();
      const Aabb from = canonical(some_box(random, scale));
      const double own = distance_of(from, world.boxes[random.below(world.boxes.size())]);
      for (const double distance : {own, std::nextafter(own, 0.0), std::nextafter(own, kInfinity)})
        world.compare(from, distance);
      if (testing::Test::HasFatalFailure()) return;
    }
    world.compare(canonical(some_box(random, scale)), kInfinity);
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Within,
                         testing::Values(VectorIsa::portable, VectorIsa::avx2, VectorIsa::avx512));

}  // namespace
}  // namespace cellsweep::queries
