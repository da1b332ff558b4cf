/// @file
/// What a few boxes tell of all, where some are many times as long as the others.
#include "engines/stream/cells/box_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/tuning.h"
#include "contract/random.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

constexpr std::size_t kBoxes = 20'000;

/// Small boxes in a large room.
std::vector<Aabb> small_boxes() {
  Random random(1);
  std::vector<Aabb> boxes(kBoxes);
  for (Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = random.between(0, 1000);
      box.max[axis] = box.min[axis] + 1;
    }
  }
  return boxes;
}

void make_large(Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) box.max[axis] = box.min[axis] + 50;
}

/// The mean volume of a box decides how many cells pay; large ones are all of it here.
void expect_alike(const std::vector<Aabb>& boxes, double factor) {
  const Boxes all(boxes.data(), boxes.size());
  const double few = take_sample(all, Look::at_few).extents.xyz;
  const double exact = take_sample(all, Look::at_all).extents.xyz;
  EXPECT_LE(std::abs(std::log(few / exact)), std::log(factor)) << few << " for " << exact;
}

TEST(BoxSample, TellsHowManyAreLargeThatStandAtEqualDistances) {
  for (std::size_t distance = 2; distance < 100; ++distance) {
    SCOPED_TRACE(distance);
    std::vector<Aabb> boxes = small_boxes();
    make_large(boxes[0]);  // which a sample always has: without a large one in it all are taken for small
    for (std::size_t i = distance / 2; i < boxes.size(); i += distance) make_large(boxes[i]);
    expect_alike(boxes, 2);
  }
}

TEST(BoxSample, TellsHowManyAreLargeThatStandInLine) {
  for (const std::size_t line : {600, 1000, 5000, 15'000}) {
    for (const std::size_t first : {std::size_t{0}, kBoxes / 2 - line / 2, kBoxes - line}) {
      SCOPED_TRACE(line);
      std::vector<Aabb> boxes = small_boxes();
      make_large(boxes[0]);
      for (std::size_t i = first; i < first + line; ++i) make_large(boxes[i]);
      expect_alike(boxes, 2);
    }
  }
}

TEST(BoxSample, OfAllIsNotThatOfAFewPlaces) {
  std::vector<Aabb> boxes = small_boxes();
  for (std::size_t i = 0; i < kBoxes; ++i) {
    if (i * tuning::kSample % kBoxes >= tuning::kSample) make_large(boxes[i]);
  }
  const BoxSample sample = take_sample(Boxes(boxes.data(), boxes.size()), Look::at_all);
  EXPECT_NEAR(sample.extents.x, 50, 2);
  EXPECT_NEAR(sample.axes[1].length, 1000, 50);
  for (std::size_t i = 0; i < kBoxes; i += 2) boxes[i] = kNobody;
  for (std::size_t i = 1; i < kBoxes; i += 2) boxes[i].min[0] = boxes[i].max[0] = 7;
  const BoxSample plane = take_sample(Boxes(boxes.data(), boxes.size()), Look::at_all);
  EXPECT_EQ(plane.axes[0].origin, 7);
  EXPECT_EQ(plane.axes[0].length, 0);
  EXPECT_NEAR(plane.extents.y, 50, 3);
}

TEST(BoxSample, OfWhichFewAreLargeIsThatOfAll) {
  std::vector<Aabb> boxes = small_boxes();
  boxes[0] = {{400, 400, 400}, {400, 400, 400}};  // where no range cuts anything of it off
  make_large(boxes[0]);
  expect_alike(boxes, 1.1);
  for (std::size_t i = 0; i < boxes.size(); i += 2000) boxes[i] = boxes[0];
  expect_alike(boxes, 1.1);
}

TEST(BoxSample, OfAFewIsThatOfAllWhereBoxesAreAlike) {
  const std::vector<Aabb> boxes = small_boxes();
  const BoxSample rough = take_rough_sample(Boxes(boxes.data(), boxes.size()));
  // Some lie across the end of an axis, and are cut off there.
  for (const double edge : {rough.extents.x, rough.extents.y, rough.extents.z}) EXPECT_NEAR(edge, 1, 0.1);
  for (const AxisRange& axis : rough.axes) EXPECT_NEAR(axis.length, 1000, 150);
}

TEST(BoxSample, OfAFewCountsLargeOnesAmongThemAsOften) {
  std::vector<Aabb> boxes = small_boxes();
  for (std::size_t i = 0; i < boxes.size(); i += 2) make_large(boxes[i]);
  EXPECT_NEAR(take_rough_sample(Boxes(boxes.data(), boxes.size())).extents.y, 25.5, 5);
}

TEST(BoxSample, OfAFewIsEmptyWhereNobodyIs) {
  const std::vector<Aabb> boxes(100, kNobody);
  const BoxSample rough = take_rough_sample(Boxes(boxes.data(), boxes.size()));
  EXPECT_EQ(rough.extents.x, 0);
  EXPECT_EQ(rough.axes[2].length, 0);
}

}  // namespace
}  // namespace cellsweep::stream
