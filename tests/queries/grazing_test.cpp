/// @file
/// Paths that just touch a box or just miss it, come to it on several axes at about the same time, or end
/// about where they do: closer than floats tell. Answers are those of the reference, to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/options.h"
#include "contract/effort.h"
#include "contract/random.h"
#include "queries/reference.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

/// Of coordinates so large that gaps between them are no floats.
constexpr float kFar = 3.5e37F;

/// Directions are scaled in one way or in another one by how long they are.
constexpr double kLengths[] = {0x1p-40, 0x1p-17, 0x1p-16, 0x1p-15, 1, 0x1p15, 0x1p16, 0x1p17, 0x1p40};

// Unless it would be beyond floats.
void make_longer(std::array<double, 3>& direction, double length) {
  const auto fits = [&](double d) { return std::fabs(d * length) <= std::numeric_limits<float>::max(); };
  if (!std::ranges::all_of(direction, fits)) return;
  for (double& d : direction) d *= length;
}

Aabb box_near_0(Random& random) {
  Aabb box;
  constexpr float kScales[] = {1, 1, 1e-30F, kFar};
  const float scale = kScales[random.below(4)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = random.between(-8, 8) * scale;
    box.max[axis] = box.min[axis] + (random.one_in(4) ? 0 : random.unit() * scale);
  }
  return box;
}

// On all axes on which the path is on its way to the box, as far as doubles can say so.
void come_at_once(Path& path, const Aabb& box, double time) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double above = double{box.min[axis]} - path.box.max[axis];
    const double below = double{box.max[axis]} - path.box.min[axis];
    const double gap = above > 0 ? above : std::fmin(below, 0);
    if (path.direction[axis] != 0) path.direction[axis] = gap / time;
  }
}

// From somewhere through a corner of the box, or through an edge, as far as floats can say so.
Path path_past(Random& random, const Aabb& box) {
  Path path;
  path.end = std::numeric_limits<double>::infinity();
  const std::size_t along = random.below(6);
  const bool is_far = box.max[0] - box.min[0] > 1e30F || random.one_in(6);
  const double way = random.unit() * 8 * double{is_far ? kFar : 1};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    float through = random.one_in(2) ? box.min[axis] : box.max[axis];
    if (axis == along) through += random.unit() * (box.max[axis] - box.min[axis]);
    path.direction[axis] = random.one_in(6) ? 0 : random.between(-1, 1);
    if (random.one_in(12)) path.direction[axis] *= 0x1p-70;
    const float extent = random.one_in(3) ? random.unit() : 0;
    const double from = through - path.direction[axis] * way;
    path.box.min[axis] = static_cast<float>(std::clamp(from, -8.0 * kFar, 8.0 * kFar));
    path.box.max[axis] = path.box.min[axis] + extent;
  }
  if (random.one_in(3)) come_at_once(path, box, random.unit() + 2);
  if (path.direction == std::array<double, 3>{}) path.direction[0] = 1;
  if (random.one_in(2)) make_longer(path.direction, kLengths[random.below(std::size(kLengths))]);
  return path;
}

std::optional<Touch> expected_touch(const Path& path, const Aabb& box) {
  const auto time = touch_time(path, box);
  return time ? std::optional(Touch{0, *time}) : std::nullopt;
}

class Grazing : public testing::TestWithParam<VectorIsa> {
 protected:
  void SetUp() override {
    if (!make_broadphase(StreamOptions{.isa = GetParam()})) GTEST_SKIP() << "not on this processor";
  }
};

TEST_P(Grazing, PathsAreAnsweredToTheLastBit) {
  constexpr int kBoxes = contract::effort(2000, 300, 50);
  Random random(3);
  for (int i = 0; i < kBoxes; ++i) {
    const Aabb box = box_near_0(random);
    auto broadphase = std::move(*make_broadphase(StreamOptions{.isa = GetParam()}));
    ASSERT_TRUE(broadphase.insert(0, box).ok());
    ASSERT_TRUE(broadphase.update().ok());
    const Queries queries = broadphase.queries();
    for (int j = 0; j < 50; ++j) {
      if (j == 5) queries.prepare();
      Path path = path_past(random, box);
      const double end = touch_time(path, box).value_or(1);
      for (const double share : {2.0, 1 + 1e-7, 1 + 1e-12, 1.0, 1 - 1e-12, 1 - 1e-7, 0.0}) {
        path.end = share * end;
        const auto expected = expected_touch(path, box);
        EXPECT_EQ(*queries.first_touch(path), expected) << "box " << i << ", path " << j << ", " << share;
        EXPECT_EQ(*queries.any_touch(path), expected.has_value()) << i << ", path " << j << ", " << share;
        std::vector<Touch> found;
        ASSERT_TRUE(queries.find_touches(path, found).ok());
        EXPECT_EQ(found.size(), expected ? 1 : 0) << i << ", path " << j << ", " << share;
      }
    }
  }
}

/// A body alone in the world, asked after with cells and with a tree.
void expect_touch(VectorIsa isa, const Path& path, const Aabb& box) {
  auto broadphase = std::move(*make_broadphase(StreamOptions{.isa = isa}));
  ASSERT_TRUE(broadphase.insert(0, box).ok());
  ASSERT_TRUE(broadphase.update().ok());
  const Queries queries = broadphase.queries();
  const auto expected = expected_touch(path, box);
  ASSERT_TRUE(expected.has_value());
  for (int time = 0; time < 2; ++time) {
    EXPECT_EQ(*queries.first_touch(path), expected);
    EXPECT_TRUE(*queries.any_touch(path));
    queries.prepare();
  }
}

// The gap on the first axis is no float, though when the path comes to the box would be one.
TEST_P(Grazing, GapsMayBeLargerThanFloats) {
  for (const double length : kLengths) {
    Ray ray{{-3e38F, -2e38F, 0}, {1.96, 1, 0}};
    make_longer(ray.direction, length);
    expect_touch(GetParam(), ray, {{1e38F, -1e37F, -1}, {1.1e38F, 5e37F, 1}});
  }
}

// It comes to the box and leaves it on all axes after more time than a double counts: at infinity, where it
// is everywhere at once.
TEST_P(Grazing, TimesMayBeLargerThanDoubles) {
  expect_touch(GetParam(), Ray{{0, 0, 0}, {1e-300, 1e-300, 1e-300}},
               {{1e10F, 1e10F, 5e10F}, {2e10F, 2e10F, 6e10F}});
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Grazing,
                         testing::Values(VectorIsa::portable, VectorIsa::avx2, VectorIsa::avx512));

}  // namespace
}  // namespace cellsweep::queries
