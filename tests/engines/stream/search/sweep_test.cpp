/// @file
/// The sweep of small worlds against brute force, on every kind of boxes, with the kernels of every
/// instruction set.
#include "engines/stream/search/sweep.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "contract/box_kinds.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using contract::Random;
using testing::IsEmpty;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Aabb kHole = {{kNan, kNan, kNan}, {kNan, kNan, kNan}};

class SweepTest : public testing::TestWithParam<VectorIsa> {
 protected:
  void SetUp() override {
    kernels_ = find_kernels(GetParam());
    if (kernels_ == nullptr || kernels_->sweep == nullptr) GTEST_SKIP() << "this machine does not have it";
  }

  /// The pairs, ascending; fails the test where the sweep would rather have cells.
  std::vector<Pair> pairs_of(const std::vector<Aabb>& boxes) {
    Keys keys;
    EXPECT_TRUE(sweep_.find(*kernels_, boxes, keys));
    std::vector<Pair> pairs;
    for (const std::uint64_t key : keys.view())
      pairs.push_back({static_cast<BodyId>(key >> 32), static_cast<BodyId>(key)});
    std::ranges::sort(pairs);
    return pairs;
  }

  const Kernels* kernels_ = nullptr;
  Sweep sweep_;
};

TEST_P(SweepTest, OfNobodyFindsNothing) {
  EXPECT_THAT(pairs_of({}), IsEmpty());
  EXPECT_THAT(pairs_of({kHole, kHole}), IsEmpty());
  EXPECT_THAT(pairs_of({kHole, Aabb{}, kHole}), IsEmpty());
}

TEST_P(SweepTest, FindsThePairsOfBruteForceInWorldsOfAnySize) {
  for (const std::size_t count : {2, 3, 15, 16, 17, 63, 64, 65, 66, 129, 500, 1000, 2048}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      std::vector<Aabb> boxes = uniform_boxes(count / kScale + 2, seed);
      EXPECT_EQ(pairs_of(boxes), pairs_among(boxes)) << count;
      boxes[boxes.size() / 2] = kHole;
      EXPECT_EQ(pairs_of(boxes), pairs_among(boxes)) << count << " with a hole";
    }
  }
}

TEST_P(SweepTest, FindsThePairsOfManyBoxes) {
  Random random(5);
  std::vector<Aabb> boxes(16'000 / kScale);
  for (Aabb& box : boxes) {
    const float x = random.between(0, 512), y = random.between(0, 32);
    box = {{x, y, 0}, {x + 0.9F, y + 0.9F, 1}};
  }
  EXPECT_EQ(pairs_of(boxes), pairs_among(boxes));
}

TEST_P(SweepTest, CountsComparisonsAndTests) {
  constexpr std::size_t kBoxes = 20;
  EXPECT_THAT(pairs_of(std::vector<Aabb>(kBoxes)), testing::SizeIs(kBoxes * (kBoxes - 1) / 2));
  EXPECT_EQ(sweep_.tests(), kBoxes * kBoxes) << "each is compared with itself and those behind it";
  pairs_of(std::vector<Aabb>(kBoxes));
  EXPECT_EQ(sweep_.tests(), 2 * kBoxes * kBoxes);
}

TEST_P(SweepTest, LeavesToCellsWhereAllMeet) {
  Keys keys;
  EXPECT_FALSE(sweep_.find(*kernels_, std::vector<Aabb>(2000), keys));
  EXPECT_THAT(keys.view(), IsEmpty());
  EXPECT_EQ(sweep_.tests(), 0U) << "before any is compared";
}

// Whether small numbers tell enough or not, every pair is found or none.
TEST_P(SweepTest, FindsAllPairsOrNoneOfEveryKindOfBoxes) {
  Random random(7);
  int found = 0;
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t count : {5U, 70U, 300U}) {
      std::vector<Aabb> boxes;
      for (const Aabb& box : make_boxes(kind, random, count)) boxes.push_back(contract::canonical_box(box));
      Keys keys;
      if (!sweep_.find(*kernels_, boxes, keys)) {
        EXPECT_THAT(keys.view(), IsEmpty()) << kind;
        continue;
      }
      ++found;
      EXPECT_EQ(pairs_of(boxes), pairs_among(boxes)) << kind;
    }
  }
  EXPECT_GT(found, 10);
}

TEST_P(SweepTest, LeavesToCellsWhatItsNumbersDoNotTellApart) {
  // One body far away on each axis, and the sample has it for the usual: all others are one number.
  std::vector<Aabb> boxes;
  Random random(3);
  for (int i = 0; i < 2000; ++i) boxes.push_back(cube_in(random, 1e-4F, 1));
  for (std::size_t i = 0; i < boxes.size(); i += 2) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float far = random.between(0, 1e5F);
      boxes[i].min[axis] = far;
      boxes[i].max[axis] = far + 1;
    }
  }
  Keys keys;
  const bool swept = sweep_.find(*kernels_, boxes, keys);
  EXPECT_LT(sweep_.tests(), std::uint64_t{64} * 16 * boxes.size()) << "whatever it decides, it is soon";
  EXPECT_TRUE(swept || keys.view().empty());
}

/// Cubes on a line, each of which overlaps about one other.
std::vector<Aabb> on_a_line(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Aabb> boxes(count);
  for (Aabb& box : boxes) {
    const float x = random.between(0, 2 * static_cast<float>(count));
    box = {{x, 0, 0}, {x + 1, 1, 1}};
  }
  return boxes;
}

// Of places that many share, each with each would be tested: with 4,096 for all of them it gave up.
TEST_P(SweepTest, FindsThePairsOfAnyNumberOnALine) {
  const std::vector<Aabb> boxes = on_a_line(100'000 / kScale, 8);
  std::vector<Pair> pairs = pairs_of(boxes);
  EXPECT_LT(sweep_.tests(), 6 * boxes.size());
  std::vector<Pair> expected;
  std::vector<Slot> order(boxes.size());
  std::iota(order.begin(), order.end(), Slot{0});
  std::ranges::sort(order, {}, [&](Slot slot) { return boxes[slot].min[0]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min[0] <= boxes[order[i]].max[0]; ++j)
      expected.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
  }
  std::ranges::sort(expected);
  EXPECT_EQ(pairs, expected);
}

// A few of them tell, without a look at all.
TEST_P(SweepTest, LeavesToCellsWhatManyMeetOnTheAxis) {
  const std::vector<Aabb> boxes = uniform_boxes(100'000 / kScale, 8);
  Keys keys;
  EXPECT_FALSE(sweep_.find(*kernels_, boxes, keys));
  EXPECT_EQ(sweep_.tests(), 0U);
  EXPECT_EQ(sweep_.bytes(), 0U) << "nothing was sorted";
}

// With 512 numbers for all of them it was 34 for each, and the sweep gave up.
TEST_P(SweepTest, ComparesFewOfThoseOnALine) {
  const std::vector<Aabb> boxes = on_a_line(2000, 9);
  EXPECT_EQ(pairs_of(boxes), pairs_among(boxes));
  EXPECT_LT(sweep_.tests(), 5 * boxes.size())
      << "each with itself, and numbers and boxes of one or two others";
}

// Of a thousand, 39 are looked at: now and then half of these lie in a third of the line.
TEST_P(SweepTest, ComparesFewOnALineWhateverItHappensToLookAt) {
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    const std::vector<Aabb> boxes = on_a_line(1000, seed);
    sweep_ = Sweep();
    EXPECT_EQ(pairs_of(boxes), pairs_among(boxes));
    EXPECT_LT(sweep_.tests(), 5 * boxes.size()) << "seed " << seed;
  }
}

TEST_P(SweepTest, KeepsWhatWasThereBefore) {
  Keys keys;
  const std::vector<Aabb> boxes = uniform_boxes(200, 5);
  ASSERT_TRUE(sweep_.find(*kernels_, boxes, keys));
  const std::size_t count = keys.view().size();
  ASSERT_TRUE(sweep_.find(*kernels_, boxes, keys));
  EXPECT_EQ(keys.view().size(), 2 * count);
}

// What it learnt of one world is of no use in the other.
TEST_P(SweepTest, IsExactAndQuickWhereBoxesHaveLeapt) {
  std::vector<Aabb> boxes = uniform_boxes(1000, 6);
  EXPECT_EQ(pairs_of(boxes), pairs_among(boxes));
  const std::uint64_t first = sweep_.tests();
  for (int leap = 0; leap < 40; ++leap) {
    for (Aabb& box : boxes) {
      box.min[leap % 3] += 1000;
      box.max[leap % 3] += 1000;
    }
    const std::uint64_t before = sweep_.tests();
    ASSERT_EQ(pairs_of(boxes), pairs_among(boxes)) << "leap " << leap;
    EXPECT_LT(sweep_.tests() - before, 3 * first) << "leap " << leap;
  }
}

TEST_P(SweepTest, StopsAtMorePairsThanThereMayBe) {
  const std::vector<Aabb> heap(160, Aabb{{0, 0, 0}, {1, 1, 1}});
  Keys keys;
  keys.buffer().most = 1000;
  EXPECT_THROW(sweep_.find(*kernels_, heap, keys), TooManyPairs);
}

INSTANTIATE_TEST_SUITE_P(Isas, SweepTest,
                         testing::Values(VectorIsa::sse41, VectorIsa::avx2, VectorIsa::avx512),
                         [](const auto& test) {
                           return "Isa" + std::to_string(static_cast<int>(test.param));
                         });

}  // namespace
}  // namespace cellsweep::stream
