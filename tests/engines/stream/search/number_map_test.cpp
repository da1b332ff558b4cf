/// @file
/// What a few boxes tell of all, before these are swept.
#include "engines/stream/search/number_map.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

const Kernels* kernels_of_bytes() {
  const Kernels* kernels = find_kernels(VectorIsa::best);
  return kernels->eight_rows != nullptr ? kernels : nullptr;
}

/// With how many behind it a box of these would be compared, by the ends on the axis.
double comparisons_of(std::vector<Aabb> boxes, unsigned axis) {
  std::ranges::sort(boxes, {}, [axis](const Aabb& box) { return box.min[axis]; });
  double sum = 0;
  for (auto box = boxes.begin(); box != boxes.end(); ++box) {
    const auto end =
        std::upper_bound(box, boxes.end(), box->max[axis],
                         [axis](float high, const Aabb& other) { return high < other.min[axis]; });
    sum += static_cast<double>(end - box - 1);
  }
  return sum / static_cast<double>(boxes.size());
}

class NumberMapTest : public testing::Test {
 protected:
  void SetUp() override {
    if (kernels_ == nullptr) GTEST_SKIP() << "this machine has no vectors of bytes";
  }

  const Kernels* kernels_ = kernels_of_bytes();
  NumberMap map_;
};

TEST_F(NumberMapTest, TellsWithHowManyABoxWouldBeCompared) {
  const std::vector<Aabb> boxes = uniform_boxes(20'000, 3);
  map_.learn(boxes);
  const double all = comparisons_of(boxes, map_.axis());
  const double expected = map_.comparisons(*kernels_, boxes);
  EXPECT_GT(expected, all / 2);
  EXPECT_LT(expected, all * 2);
}

// Their edges by the length of the world would tell of two or three.
TEST_F(NumberMapTest, TellsOfCrowdsInAWideWorld) {
  Random random(4);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 20'000; ++i) {
    Aabb box = cube_in(random, 10, 0.1F);
    for (const std::size_t axis : {0U, 1U, 2U}) {
      box.min[axis] += static_cast<float>(i % 8) * 10'000;
      box.max[axis] += static_cast<float>(i % 8) * 10'000;
    }
    boxes.push_back(box);
  }
  map_.learn(boxes);
  EXPECT_GT(map_.comparisons(*kernels_, boxes), comparisons_of(boxes, map_.axis()) / 2);
}

TEST_F(NumberMapTest, TellsNothingOfNobody) {
  const std::vector<Aabb> boxes(100, kNobody);
  map_.learn(boxes);
  EXPECT_EQ(map_.comparisons(*kernels_, boxes), 0);
}

TEST_F(NumberMapTest, IsGoodForBoxesThatAreWhereTheyWereForATime) {
  std::vector<Aabb> boxes = uniform_boxes(1000, 5);
  EXPECT_FALSE(map_.is_good_for(*kernels_, boxes)) << "it has learnt nothing";
  map_.learn(boxes);
  int uses = 0;
  while (map_.is_good_for(*kernels_, boxes)) ASSERT_LT(++uses, 1000);
  EXPECT_GT(uses, 4);
  map_.learn(boxes);
  boxes.pop_back();
  EXPECT_FALSE(map_.is_good_for(*kernels_, boxes)) << "others may be in their slots";
}

TEST_F(NumberMapTest, IsNotGoodForBoxesThatHaveLeapt) {
  for (const std::size_t axis : {0U, 1U, 2U}) {
    for (const float leap : {-1000.0F, 1000.0F}) {
      std::vector<Aabb> boxes = uniform_boxes(1000, 6);
      map_.learn(boxes);
      for (Aabb& box : boxes) {
        box.min[axis] += leap;
        box.max[axis] += leap;
      }
      EXPECT_FALSE(map_.is_good_for(*kernels_, boxes)) << "axis " << axis << ", by " << leap;
    }
  }
}

}  // namespace
}  // namespace cellsweep::stream
