/// @file
/// Boxes of any kind become a world's: rounded outward and no further, and not copied without need.
#include "bindings/boxes_of_world.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "contract/random.h"

namespace cellsweep::bindings {
namespace {

using contract::Random;
using Boxes2 = std::vector<Box<double, 2>>;
using Boxes3 = std::vector<Box<double, 3>>;

std::vector<Aabb> converted(const BoxView& view) {
  std::vector<Aabb> own;
  const auto boxes = boxes_of_world(view, own);
  return {boxes.begin(), boxes.end()};
}

/// Of all magnitudes, near to floats and exactly floats, of both signs.
double any_number(Random& random) {
  const double size = std::ldexp(1.0 + random.unit(), random.whole(-160, 126));
  const double number = random.one_in(4) ? static_cast<double>(static_cast<float>(size)) : size;
  return random.one_in(8) ? 0.0 : random.one_in(2) ? number : -number;
}

bool is_canonical(float number) {
  return number == 0 || std::fabs(number) >= FLT_MIN;
}

/// The neighbour of a canonical number among these, towards infinity or away from it.
float step(float number, float towards) {
  if (number == 0) return towards > 0 ? FLT_MIN : -FLT_MIN;
  const float next = std::nextafter(number, towards);
  return is_canonical(next) ? next : 0;
}

TEST(BoxesOfAWorld, DoublesAreRoundedToTheNextFloatOutward) {
  Random random(1);
  Boxes3 boxes(20000);
  for (auto& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double one = any_number(random);
      const double other = random.one_in(3) ? one : any_number(random);
      box.min[axis] = std::min(one, other);
      box.max[axis] = std::max(one, other);
    }
  }
  const std::vector<Aabb> rounded = converted(boxes);
  ASSERT_EQ(rounded.size(), boxes.size());
  constexpr float kFar = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float low = rounded[i].min[axis];
      const float high = rounded[i].max[axis];
      ASSERT_TRUE(is_canonical(low) && is_canonical(high));
      ASSERT_LE(low, boxes[i].min[axis]);
      ASSERT_GT(step(low, kFar), boxes[i].min[axis]);
      ASSERT_GE(high, boxes[i].max[axis]);
      ASSERT_LT(step(high, -kFar), boxes[i].max[axis]);
    }
  }
}

TEST(BoxesOfAWorld, WhatIsNoBoxOfDoublesIsNoneOfFloats) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Boxes3 boxes = {
      {{1 + 1e-12, 0, 0}, {1, 1, 1}}, {{0, 1e-41, 0}, {1, 0, 1}}, {{0, 0, 0}, {1, 1, -1e-300}},
      {{0, 0, kNaN}, {1, 1, 1}},      {{0, 0, 0}, {1, kNaN, 1}},  {{-kFar, 0, 0}, {1, 1, 1}},
      {{0, 0, 0}, {1, 1, 4e38}},      {{-4e38, 0, 0}, {1, 1, 1}}, {{4e38, 0, 0}, {5e38, 1, 1}}};
  for (const Aabb& box : converted(boxes)) {
    bool valid = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      valid &= box.min[axis] <= box.max[axis] && std::isfinite(box.min[axis]) && std::isfinite(box.max[axis]);
    }
    EXPECT_FALSE(valid);
  }
}

TEST(BoxesOfAWorld, FloatsStayWhatTheyAreToTheBit) {
  CoordinateArrays<float, 3> arrays;
  const std::vector<float> numbers = {-0.0F, 1e-41F, 3.5F, std::numeric_limits<float>::quiet_NaN()};
  for (std::size_t axis = 0; axis < 3; ++axis) arrays.min[axis] = arrays.max[axis] = {numbers.data()};
  arrays.count = numbers.size();
  const std::vector<Aabb> boxes = converted(arrays);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(std::memcmp(&boxes[i].max[2], &numbers[i], sizeof(float)), 0);
  }
}

TEST(BoxesOfAWorld, InTwoDimensionsTheThirdIsFromZeroToZero) {
  const Boxes2 boxes = {{{1, 2}, {3, 4}}, {{-1, -2}, {0, 0.5}}};
  const std::vector<Aabb> expected = {{{1, 2, 0}, {3, 4, 0}}, {{-1, -2, 0}, {0, 0.5, 0}}};
  EXPECT_EQ(converted(boxes), expected);
}

TEST(BoxesOfAWorld, ArraysOfBoxesAreNotCopied) {
  const std::vector<Aabb> boxes = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}};
  std::vector<Aabb> own;
  const auto view = boxes_of_world(boxes, own);
  EXPECT_EQ(view.data(), boxes.data());
  EXPECT_TRUE(own.empty());
}

TEST(BoxesOfAWorld, CoordinatesMayLieAnywhere) {
  // Backwards, and at odd addresses.
  const std::vector<Aabb> boxes = {{{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {10, 11, 12}}};
  std::vector<std::byte> bytes(2 * sizeof(Aabb) + 1);
  std::memcpy(bytes.data() + 1, boxes.data(), 2 * sizeof(Aabb));
  CoordinateArrays<float, 3> arrays;
  arrays.count = 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto* last = reinterpret_cast<const float*>(bytes.data() + 1 + sizeof(Aabb)) + axis;
    arrays.min[axis] = {last, -static_cast<std::ptrdiff_t>(sizeof(Aabb))};
    arrays.max[axis] = {last + 3, -static_cast<std::ptrdiff_t>(sizeof(Aabb))};
  }
  EXPECT_EQ(converted(arrays), (std::vector<Aabb>{boxes[1], boxes[0]}));
}

}  // namespace
}  // namespace cellsweep::bindings
